package radiosity.output.grid;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.input.assembly.LeftOut;
import radiosity.scene.Hierarchy;
import radiosity.scene.ImageMap;
import radiosity.scene.Light;
import radiosity.scene.Raster;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Units;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.testkit.Box;
import radiosity.testkit.Cells;
import radiosity.testkit.RoomScenes;
import radiosity.testkit.Solve;

/**
 * Grids on surfaces and in the air.
 *
 * <p>In a closed room in which every surface emits M and reflects rho, B = M / (1 - rho) everywhere, and so is what arrives
 * anywhere, on surfaces or in the air. A point source of intensity I gives I h / d³ on a plane h below it.
 */
@Tag("slow")
class GridTest {

    private static final double[] SIDE = {0, 4};
    private static final Units LUX = new Units(1, true);

    private static Scene room(double exitance, double reflectance) {
        return room(exitance, reflectance, reflectance);
    }

    private static Scene room(double exitance, double reflectance, double ofFloor) {
        Surface wall = RoomScenes.grey("wall", exitance, reflectance);
        Surface floor = RoomScenes.grey("floor", exitance, ofFloor);
        return new Cells(SIDE, new double[] {0, 3}, SIDE).room("room", (i, j, k) -> true,
                (i, j, k, side) -> side == 2 ? floor : wall).with(LUX);
    }

    private static Scene withBulb() {
        Scene dark = room(0, 0, .5);
        return dark.with(dark.surfaces(), List.of(new Light("bulb", Light.Kind.POINT, Rgb.grey(1000), new Vec3(2, 2.5, 2),
                Vec3.ZERO, Vec3.ZERO, Vec3.ZERO, 1, 0, 0)));
    }

    private static Grid grid(Solution solution, String where, double spacing) {
        return Grid.of(solution, where, spacing, 2);
    }

    private static double ofBulb(double[] row) {
        double h = 2.5 - row[1];
        double x = row[0] - 2;
        double z = row[2] - 2;
        return 1000 * h / Math.pow(x * x + h * h + z * z, 1.5);
    }

    @Test
    void surface_hasAMeanAndAUniformity() {
        Grid grid = grid(Solve.byDefault().solution(withBulb()), "floor", .5);
        assertEquals(64, grid.rows().length);
        double sum = 0;
        double least = Double.MAX_VALUE;
        for (double[] row : grid.rows()) {
            assertEquals(ofBulb(row), row[6], 2e-3 * ofBulb(row));
            assertEquals(.25, row[0] % .5, 1e-9, "in the middle of a cell");
            sum += ofBulb(row);
            least = Math.min(least, ofBulb(row));
        }
        assertEquals(sum / 64, grid.mean(), .05);
        assertEquals(least, grid.minimum(), 2e-3 * least);
        double most = ofBulb(new double[] {1.75, 0, 1.75});
        assertEquals(most, grid.maximum(), 2e-3 * most);
        assertEquals(least / (sum / 64), grid.uniformity(), .002);
        assertTrue(grid.summary().matches("floor: average illuminance 100\\.\\d lx, minimum .*, uniformity U0 0\\.\\d\\d,"
                + " 64 points"), grid.summary());
    }

    /** Two halves of a square of 2 x 2 m whose heights differ by less than a square of this size can tell. */
    @Test
    void trianglesOfOnePlane_shareOneGrid() {
        Surface floor = RoomScenes.grey("floor", 0, .5);
        for (double height = 0; height < 5e-4; height += 1e-5) {
            double low = height - 1e-9;
            double high = height + 1e-9;
            Scene square = new SceneBuilder()
                    .polygon(floor, new Vec3(0, low, 0), new Vec3(0, low, 2), new Vec3(2, low, 2))
                    .polygon(floor, new Vec3(0, high, 0), new Vec3(2, high, 2), new Vec3(2, high, 0)).scene("floor");
            assertEquals(1, GridPlaces.of(square, "floor", 2).points().size(), "height " + height);
        }
    }

    /** A wall of 6 x 6 squares turned by 30 degrees, in coordinates of 4 decimals as exporters write. */
    @Test
    void pointsOfAGrid_lieOnTheRoundedTrianglesOfATurnedWall() {
        SceneBuilder builder = new SceneBuilder();
        for (int i = 0; i < 36; i++) {
            builder.polygon(RoomScenes.grey("wall", 1, .5), onWall(i % 6, i / 6), onWall(i % 6 + 1, i / 6),
                    onWall(i % 6 + 1, i / 6 + 1), onWall(i % 6, i / 6 + 1));
        }
        Grid grid = grid(Solve.byDefault().accurate(.5).solution(builder.scene("wall")), "wall", .4);
        assertEquals(0, grid.left());
        assertTrue(grid.rows().length > 80, "points: " + grid.rows().length);
    }

    /** A floor of 8 x 6 m in triangles of some 10 cm, whose corners are up to 5 mm off, as a scanner has it. */
    @Test
    void pointsOnAScan_areAsManyAsTheSpacingSays_andStandForItsArea() {
        Random random = new Random(3);
        Vec3[][] at = new Vec3[81][61];
        for (int i = 0; i < 81; i++) {
            for (int j = 0; j < 61; j++) {
                at[i][j] = new Vec3(i * .1, random.nextDouble() * .01, j * .1);
            }
        }
        Surface scan = RoomScenes.grey("scan", 0, .5);
        SceneBuilder builder = new SceneBuilder();
        for (int i = 0; i < 80; i++) {
            for (int j = 0; j < 60; j++) {
                builder.polygon(scan, at[i][j], at[i][j + 1], at[i + 1][j + 1]);
                builder.polygon(scan, at[i][j], at[i + 1][j + 1], at[i + 1][j]);
            }
        }
        Scene scene = builder.scene("scan");
        for (double spacing : new double[] {.2, .5, 3, 100}) {
            GridPlaces places = GridPlaces.of(scene, "scan", spacing);
            assertEquals(Math.max(1, Math.rint(scene.area() / spacing / spacing)), places.points().size());
            assertEquals(scene.area(), places.areas().stream().mapToDouble(a -> a).sum(), 1e-9);
        }
        List<Vec3> points = GridPlaces.of(scene, "scan", .5).points();
        assertEquals(4, points.stream().mapToDouble(Vec3::x).average().orElseThrow(), .1);
        assertEquals(3, points.stream().mapToDouble(Vec3::z).average().orElseThrow(), .3);
    }

    private static Vec3 onWall(int i, int j) {
        double along = i * 5.2371 / 6;
        return new Vec3(Math.round(along * Math.sqrt(.75) * 1e3) / 1e3, Math.round(j * 3.0713 / 6 * 1e3) / 1e3,
                Math.round(along * .5 * 1e3) / 1e3);
    }

    /** The same room, as far from the origin as a survey's coordinates are. */
    @Test
    void planeInTheAir_receivesReflectedLight_farFromTheOrigin() {
        double[] mean = new double[2];
        for (int i = 0; i < 2; i++) {
            Vec3 away = new Vec3(500_000, 12, 4_000_000).times(i);
            SceneBuilder builder = new SceneBuilder();
            RoomScenes.addRoom(builder, RoomScenes.grey("room", 3, .4), new Box(away, away.plus(new Vec3(4, 3, 4))));
            mean[i] = grid(Solve.byDefault().accurate(.1).solution(builder.scene("room")),
                    "y=" + (away.y() + 1), 1.5).mean();
        }
        assertEquals(5, mean[0], .1);
        assertEquals(mean[0], mean[1], 1e-3 * mean[0]);
    }

    /** A square below a lamp is a scene without height. */
    @Test
    void planeInTheAir_mayBeBetweenAFloorAndItsLamps() {
        Scene square = new SceneBuilder().polygon(RoomScenes.grey("floor", 0, .5), Vec3.ZERO, new Vec3(0, 0, 4),
                new Vec3(4, 0, 4), new Vec3(4, 0, 0)).light(withBulb().lights().get(0)).scene("square");
        assertEquals(16, GridPlaces.of(square, "y=1", 1).points().size());
        assertThrows(IllegalArgumentException.class, () -> GridPlaces.of(square, "y=9", 1));
        assertThrows(IllegalArgumentException.class, () -> GridPlaces.of(square, "y=1.2.3", 1));
    }

    @Test
    void planeInTheAir_receivesLight_fromLights() {
        Grid grid = grid(Solve.byDefault().solution(withBulb()), "y=0.85", 1);
        assertEquals(16, grid.rows().length);
        assertArrayEquals(grid.rows(), Grid.of(Solve.byDefault().solution(withBulb()), "y=0.85", 1, 1).rows());
        for (double[] row : grid.rows()) {
            assertEquals(.85, row[1]);
            assertEquals(ofBulb(row), row[6], 1e-3 * ofBulb(row));
        }
        Grid below = grid(Solve.byDefault().solution(withBulb()), "-y=0.85", 1);
        assertEquals(50, below.mean(), 25, "what the floor reflects");
    }

    @Test
    void planeInTheAir_receivesLight_fromAllThatEmitsAndReflects() {
        Solution solution = Solve.byDefault().solution(room(3, .4));
        for (String plane : List.of("y=1", "-y=1", "x=1.3", "-z=3.9")) {
            Grid grid = grid(solution, plane, 1.5);
            for (double[] row : grid.rows()) {
                assertEquals(5, row[6], .02, plane);
            }
        }
    }

    /** An L-shaped room, with a box on its floor: 12 of 16 cells are air, and one of them is in the box. */
    @Test
    void pointsInSolidsAndOutside_areLeftOut() {
        Surface wall = RoomScenes.grey("wall", 1, .5);
        double[] x = {0, 1, 2, 3, 4};
        Scene room = new Cells(x, new double[] {0, 1, 3}, x).room("L", (i, j, k) -> !(i > 1 && k > 1)
                && !(i == 0 && k == 0 && j == 0), wall).with(LUX);
        Grid grid = grid(Solve.byDefault().solution(room), "y=0.5", 1);
        assertEquals(11, grid.rows().length);
        assertEquals(5, grid.left());
        assertEquals(2, grid.mean(), .02);
    }

    /** The only cell's middle lies in the box. */
    @Test
    void gridWithoutPoints_hasNoFigures() {
        SceneBuilder builder = new SceneBuilder();
        RoomScenes.addRoom(builder, RoomScenes.grey("wall", 1, .5), new Box(Vec3.ZERO, new Vec3(4, 3, 4)));
        Box box = new Box(new Vec3(1, 0, 1), new Vec3(3, 1, 3));
        for (int side = 0; side < 6; side++) {
            Vec3[] inside = box.inside(side);
            builder.polygon(RoomScenes.grey("box", 0, .5), inside[3], inside[2], inside[1], inside[0]);
        }
        Grid grid = grid(Solve.byDefault().accurate(.2).solution(builder.scene("box in a room")), "y=0.5", 4);
        assertEquals(0, grid.rows().length);
        assertTrue(Double.isNaN(grid.mean()) && Double.isNaN(grid.uniformity()));
        assertEquals("y=0.5: no points, as 1 inside solids or outside are left out: on a plane that lies on a surface"
                + " give the surface's name, where faces look both ways give --two-sided (of OBJ), in a small room a"
                + " smaller --spacing",
                grid.summary());
    }

    /** A table of 4 x 4 m and a block on it of .4 x .4 m, whose only point stands for its area. */
    @Test
    void mean_isThatOfTheArea() {
        Surface wood = RoomScenes.grey("wood", 0, 0);
        SceneBuilder builder = new SceneBuilder();
        for (double[] square : new double[][] {{0, 4, 0}, {6, 6.4, 1}}) {
            double low = square[0];
            double high = square[1];
            double y = square[2];
            builder.polygon(wood, new Vec3(low, y, low), new Vec3(low, y, high), new Vec3(high, y, high),
                    new Vec3(high, y, low));
        }
        Scene tables = builder.light(Light.sun(new Vec3(0, 1, 0), 100)).light(new Light("bulb", Light.Kind.POINT,
                Rgb.grey(1000), new Vec3(6.2, 2, 6.2), Vec3.ZERO, Vec3.ZERO, Vec3.ZERO, 1, 0, 0)).scene("tables")
                .with(LUX);
        Grid grid = grid(Solve.byDefault().solution(tables), "wood", 1);
        double sum = 0;
        for (double[] row : grid.rows()) {
            sum += row[6] * (row[1] == 1 ? .16 : 1);
        }
        assertEquals(17, grid.rows().length);
        assertEquals(sum / 16.16, grid.mean(), 1e-9 * sum);
    }

    /** Only the right half of a lamp shines, by its image. */
    @Test
    void imageOfALamp_saysWhereItShines() {
        Raster image = new Raster(64, 1, halfLit(64), ImageMap.Wrap.REPEAT, ImageMap.Wrap.REPEAT, Rgb.BLACK);
        Surface lamp = RoomScenes.grey("lamp", 1, 0).with(new Surface.Maps(Optional.of(image), Optional.empty()));
        Surface floor = RoomScenes.grey("floor", 0, 0);
        SceneBuilder builder = new SceneBuilder().polygon(floor, new Vec3(-4, 0, -4), new Vec3(-4, 0, 4),
                new Vec3(4, 0, 4), new Vec3(4, 0, -4));
        Scene plain = lamps(builder, RoomScenes.grey("lamp", 1, 0), 0);
        Scene half = lamps(new SceneBuilder().polygon(floor, new Vec3(-4, 0, -4), new Vec3(-4, 0, 4),
                new Vec3(4, 0, 4), new Vec3(4, 0, -4)), lamp, -1);
        Scene imaged = new Scene("lamp", half.points(), half.corners(), half.surfaceOf(), half.surfaces(), List.of(),
                Optional.empty(), new float[] {0, 0, 0, 1, 1, 1, 0, 0, 1, 1, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1},
                new float[0], Hierarchy.NONE).with(LUX);
        Grid expected = grid(Solve.byDefault().solution(plain), "y=0.001", 1);
        Grid grid = grid(Solve.byDefault().solution(imaged), "y=0.001", 1);
        for (int i = 0; i < grid.rows().length; i++) {
            assertEquals(expected.rows()[i][6], grid.rows()[i][6], .02 * expected.maximum(), "point " + i);
        }
    }

    private static float[] halfLit(int width) {
        float[] rgb = new float[3 * width];
        Arrays.fill(rgb, 3 * width / 2, 3 * width, 1);
        return rgb;
    }

    /** A lamp at a height of 1 m that shines down, from the given x to 1. */
    private static Scene lamps(SceneBuilder builder, Surface lamp, double from) {
        return builder.polygon(lamp, new Vec3(from, 1, -1), new Vec3(1, 1, -1), new Vec3(1, 1, 1),
                new Vec3(from, 1, 1)).scene("lamp").with(LUX);
    }

    @Test
    void table_hasItsFiguresAndPoints(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("floor.csv");
        grid(Solve.byDefault().solution(room(3, .4)), "floor", 2).write(file);
        List<String> lines = Files.readAllLines(file);
        assertEquals("# floor", lines.get(0));
        assertTrue(lines.get(1).matches("# average illuminance,[45]\\.\\d+,lx"), lines.get(1));
        assertTrue(lines.get(4).matches("# uniformity U0 \\(minimum / average\\),(1\\.0|0\\.99\\d+)"), lines.get(4));
        assertEquals("x,y,z,nx,ny,nz,E_lx", lines.get(7));
        assertEquals(8 + 4, lines.size());
    }

    /**
     * A black room whose pane in the ceiling is left out. The sky's light at a point is the integral over the opening;
     * under a level place in the open the CIE's overcast sky of zenith luminance 1 gives 7 pi / 9.
     */
    @Test
    void daylightFactors_areThoseOfTheOpening(@TempDir Path folder) throws IOException {
        Scene open = skylit(List.of(Light.sky(Light.Kind.SKY_OVERCAST, 8000, new Vec3(0, 1, 0), Vec3.ZERO)));
        Grid grid = grid(Solve.byDefault().solution(open), "y=1", 1);
        double[] expected = Arrays.stream(grid.rows()).mapToDouble(GridTest::throughOpening).sorted().toArray();
        DaylightFactor factor = grid.daylight().orElseThrow();
        assertEquals(16, grid.rows().length);
        assertEquals(Arrays.stream(expected).average().orElseThrow(), factor.average(), .01 * factor.average());
        assertEquals(expected[8], factor.median(), .02 * factor.median());
        assertEquals(expected[0], factor.exceeded(), .02 * factor.exceeded());
        assertTrue(grid.summary().matches(".*, 16 points, daylight factor average \\d.\\d\\d %, median \\d.\\d\\d,"
                + " over 95 % of the area at least \\d.\\d\\d"), grid.summary());
        Path file = folder.resolve("plane.csv");
        grid.write(file);
        List<String> lines = Files.readAllLines(file);
        assertEquals("# daylight factor average," + factor.average() + ",%", lines.get(7));
        assertEquals("x,y,z,nx,ny,nz,E_lx,DF_percent", lines.get(10));
        String[] first = lines.get(11).split(",");
        assertEquals(Double.parseDouble(first[6]) / 80, Double.parseDouble(first[7]), 1e-9);
    }

    @Test
    void daylightFactors_areOfOvercastSkiesOnly() throws IOException {
        Light overcast = Light.sky(Light.Kind.SKY_OVERCAST, 8000, new Vec3(0, 1, 0), Vec3.ZERO);
        Light uniform = Light.sky(Light.Kind.SKY_UNIFORM, 8000, new Vec3(0, 1, 0), Vec3.ZERO);
        Light bulb = new Light("bulb", Light.Kind.POINT, Rgb.grey(1000), new Vec3(2, 2.5, 2), Vec3.ZERO, Vec3.ZERO,
                Vec3.ZERO, 1, 0, 0);
        for (List<Light> lights : List.of(List.of(uniform), List.of(overcast, bulb), List.of(bulb))) {
            Grid grid = grid(Solve.byDefault().solution(skylit(lights)), "y=1", 2);
            assertEquals(Optional.empty(), grid.daylight());
        }
    }

    private static Scene skylit(List<Light> lights) throws IOException {
        double[] side = {0, 1.5, 2.5, 4};
        Surface wall = RoomScenes.grey("wall", 0, 0);
        Surface pane = RoomScenes.grey("pane", 0, 0);
        Scene closed = new Cells(side, new double[] {0, 3}, side).room("room", (i, j, k) -> true,
                (i, j, k, face) -> face == 3 && i == 1 && k == 1 ? pane : wall).with(LUX);
        Scene open = LeftOut.of(closed, Set.of("pane"));
        return open.with(open.surfaces(), lights);
    }

    /** Percent of the light of the open that reaches a point 2 m below the opening. */
    private static double throughOpening(double[] row) {
        int n = 200;
        double sum = 0;
        for (int i = 0; i < n * n; i++) {
            double x = 1.5 + (i / n + .5) / n - row[0];
            double z = 1.5 + (i % n + .5) / n - row[2];
            double squared = x * x + 4 + z * z;
            sum += (1 + 2 * 2 / Math.sqrt(squared)) / 3 * 4 / (squared * squared);
        }
        return 100 * sum / (n * n) / (7 * Math.PI / 9);
    }

    @Test
    void whatCannotBe_isRefused() {
        for (String where : List.of("ceiling", "y=4", "y=", "floor,wall")) {
            assertThrows(IllegalArgumentException.class, () -> Grid.check(room(1, 0), where, 1), where);
        }
        assertThrows(IllegalArgumentException.class, () -> Grid.check(room(1, 0), "floor", 1e-3));
    }
}
