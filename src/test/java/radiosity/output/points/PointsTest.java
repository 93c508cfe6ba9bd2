package radiosity.output.points;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.output.gltf.Handmade;
import radiosity.scene.Rgb;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;

class PointsTest {

    private static final Vec3 X = new Vec3(1, 0, 0);
    private static final Vec3 Y = new Vec3(0, 1, 0);
    private static final Vec3 Z = new Vec3(0, 0, 1);

    @TempDir
    Path folder;
    private Path in;
    private Path out;

    @BeforeEach
    void files() {
        in = folder.resolve("in.csv");
        out = folder.resolve("out.csv");
    }

    private static Rgb linear(Vec3 p) {
        return new Rgb(1 + p.x() + 2 * p.y() + 3 * p.z(), 2 - p.x(), p.y());
    }

    private static Solution room() {
        return Handmade.room(Vec3.ZERO, 1, PointsTest::linear).solution();
    }

    private long run(String... lines) throws IOException {
        Files.write(in, List.of(lines));
        return new Points(room()).write(in, out);
    }

    private double[] row(int i) throws IOException {
        return Arrays.stream(Files.readAllLines(out).get(i).split(",")).mapToDouble(Double::parseDouble)
                .toArray();
    }

    @Test
    void linearLight_isInterpolatedExactly() {
        Points points = new Points(room());
        Random random = new Random(4);
        for (int i = 0; i < 1000; i++) {
            Vec3 p = new Vec3(random.nextDouble(), 0, random.nextDouble());
            Points.Light light = points.at(p, Y);
            assertEquals(linear(p).r(), light.irradiance().r(), 1e-12);
            assertEquals(linear(p).g(), light.irradiance().g(), 1e-12);
            assertEquals(.7 * linear(p).r(), light.radiosity().r(), 1e-12);
        }
    }

    @Test
    void light_ofEmitters_includesTheirExitance() {
        Handmade made = new Handmade();
        made.grid(made.surface("lamp", new Rgb(5, 6, 7), Rgb.grey(.5), false), Vec3.ZERO, X, Y, 1, 1, p -> Rgb.grey(2));
        assertEquals(new Rgb(6, 7, 8), new Points(made.solution()).at(new Vec3(.25, .5, 0), Z).radiosity());
    }

    @Test
    void normal_choosesTheSideAndTheWall() {
        Handmade made = new Handmade();
        int s = made.surface("sheet", Rgb.BLACK, Rgb.grey(.5), true);
        int t = made.triangle(s, Vec3.ZERO, X, Y);
        for (int side = 0; side < 2; side++) {
            Rgb h = Rgb.grey(1 + side);
            int a = made.vertex(Vec3.ZERO, h);
            int b = made.vertex(side == 0 ? X : Y, h);
            int c = made.vertex(side == 0 ? Y : X, h);
            made.element(2 * t + side, a, b, c);
        }
        made.grid(made.surface("wall", .5), Vec3.ZERO, Y, Z, 1, 1, p -> Rgb.grey(3));
        Points points = new Points(made.solution());
        assertEquals(1, points.at(new Vec3(.2, .2, 0), new Vec3(0, 0, 2)).irradiance().r());
        assertEquals(2, points.at(new Vec3(.2, .2, 0), new Vec3(0, 0, -1)).irradiance().r());
        assertEquals(1, points.at(new Vec3(0, .2, 0), Z).irradiance().r());
        assertEquals(3, points.at(new Vec3(0, .2, 0), X).irradiance().r());
    }

    @Test
    void pointOnNoSurface_orOnItsDarkSide_isCountedAndNan() throws IOException {
        assertEquals(2, run("0.5,0.5,0.5,0,1,0", "0.5,0,0.5,0,-1,0", "0.5,0,0.5,0,1,0"));
        assertTrue(Files.readAllLines(out).get(1).endsWith(",nan,nan,nan,nan,nan,nan"));
        assertTrue(Files.readAllLines(out).get(2).endsWith(",nan,nan,nan,nan,nan,nan"));
        assertEquals(3, row(3)[6], 1e-12);
    }

    @Test
    void points_beyondTheEdgeByRounding_areOnTheSurface() {
        assertEquals(linear(new Vec3(1, 0, .5)).r(),
                new Points(room()).at(new Vec3(1 + 1e-9, -1e-9, .5), Y).irradiance().r(), 1e-8);
    }

    /** The room has sides of 1, a diagonal of 1.73. */
    @Test
    void pointsBesideARoughSurface_haveTheLightOfTheNearestPlaceInTheTable() throws IOException {
        assertEquals(1, run("0.25,0.0015,0.5,0,1,0", "0.25,-0.0015,0.5,0,1,0", "0.25,0.0015,0.5,0.5,0.866,0",
                "0.25,0.002,0.5,0,1,0"));
        for (int i = 1; i <= 3; i++) {
            assertEquals(linear(new Vec3(.25, 0, .5)).r(), row(i)[6], 1e-12);
        }
        assertTrue(Files.readAllLines(out).get(4).endsWith(",nan,nan,nan,nan,nan,nan"));
        assertTrue(Double.isNaN(new Points(room()).at(new Vec3(.25, .0015, .5), Y).irradiance().r()));
    }

    @Test
    void output_beginsWithItsHeaderAndGivesThePointsBack() throws IOException {
        run("0.1,0,0.30000000000000004,0,1,0");
        assertEquals("x,y,z,nx,ny,nz,H_r,H_g,H_b,B_r,B_g,B_b", Files.readAllLines(out).get(0));
        double[] row = row(1);
        assertEquals(12, row.length);
        assertEquals(.1 + .2, row[2]);
        assertEquals(1 + .1 + .9, row[6], 1e-12);
        assertEquals(.7 * 2, row[9], 1e-12);
    }

    @Test
    void fileWithoutPoints_isRefused() throws IOException {
        SceneFormatException wrong = assertThrows(SceneFormatException.class,
                () -> run("# A heading", "", "Some text."));
        assertTrue(wrong.getMessage().endsWith(": expected points, as x, y, z, nx, ny, nz per line, got none"),
                wrong.getMessage());
    }

    @Test
    void headerWithNames_choosesTheColumns() throws IOException {
        run("\ufeff# a comment", "", "idx,NX,ny,nz,\"x\",y,z,w", "7, 0,1,0, 0.25,0,0.5, 9");
        assertEquals(linear(new Vec3(.25, 0, .5)).r(), row(1)[6], 1e-12);
    }

    @Test
    void headerWithNames_isFollowedByPointsOnly_alsoWhereTheirFirstColumnIsText() throws IOException {
        run("id,x,y,z,nx,ny,nz", "a,0.25,0,0.5,0,1,0", "b,0.5,0,0.5,0,1,0");
        assertEquals(3, Files.readAllLines(out).size());
        assertEquals(linear(new Vec3(.25, 0, .5)).r(), row(1)[6], 1e-12);
        assertEquals(linear(new Vec3(.5, 0, .5)).r(), row(2)[6], 1e-12);
    }

    @Test
    void decimalCommas_areReadBetweenSemicolons() throws IOException {
        run("\"x\";\"y\";\"z\";\"nx\";\"ny\";\"nz\"", "0,5;0,0;0,25;0,0;1,0;0,0");
        assertEquals(linear(new Vec3(.5, 0, .25)).r(), row(1)[6], 1e-9);
        run("0.5;0;0.25;0;1;0");
        assertEquals(linear(new Vec3(.5, 0, .25)).r(), row(1)[6], 1e-9);
        run("\"0.5\",\"0\",\"0.25\",\"0\",\"1\",\"0\"");
        assertEquals(linear(new Vec3(.5, 0, .25)).r(), row(1)[6], 1e-9);
    }

    @Test
    void headerWithoutNames_leavesTheFirstSixColumns() throws IOException {
        run("made by hand", "0.25;0;0.5;0;1;0;99");
        assertEquals(linear(new Vec3(.25, 0, .5)).r(), row(1)[6], 1e-12);
    }

    @Test
    void badLine_isNamedWithItsNumber() {
        assertMessage("line 2: expected a number for nz, got nothing", "0,0,0,0,1,0", "1,2,3,0,1");
        assertMessage("line 2: expected a number for y, got abc", "0,0,0,0,1,0", "1,abc,3,0,1,0");
        assertMessage("line 1: expected a number for x, got NaN", "NaN,0,0,0,1,0");
        assertMessage("line 1: expected a normal longer than 0, got 1,2,3,0,0,0", "1,2,3,0,0,0");
        assertMessage("line 1: expected columns x,y,z,nx,ny,nz, got x,y,z", "x,y,z");
    }

    private void assertMessage(String message, String... lines) {
        SceneFormatException e = assertThrows(SceneFormatException.class, () -> run(lines));
        assertEquals(in + ", " + message, e.getMessage());
    }

    @Test
    void binaryInput_isRefusedInOneLine() throws IOException {
        Files.write(in, new byte[] {(byte) 0xff, (byte) 0xfe, 0, 1});
        assertThrows(SceneFormatException.class, () -> new Points(room()).write(in, out));
    }

    /** A block without a bottom, seen from outside, in the middle of a floor whose two elements run on below it. */
    @Test
    void floorUnderABlock_isBlack() {
        Handmade room = Handmade.room(Vec3.ZERO, 1, p -> Rgb.grey(2));
        int block = room.surface("block", .5);
        Vec3 at = new Vec3(.3, 0, .3);
        Vec3 x = X.times(.4);
        Vec3 y = Y.times(.4);
        Vec3 z = Z.times(.4);
        room.grid(block, at.plus(y), z, x, 1, 1, p -> Rgb.BLACK);
        room.grid(block, at, y, x, 1, 1, p -> Rgb.BLACK);
        room.grid(block, at, z, y, 1, 1, p -> Rgb.BLACK);
        room.grid(block, at.plus(z), x, y, 1, 1, p -> Rgb.BLACK);
        room.grid(block, at.plus(x), y, z, 1, 1, p -> Rgb.BLACK);
        Points points = new Points(room.solution());
        assertEquals(0, points.at(new Vec3(.31, 0, .31), Y).irradiance().r());
        assertEquals(0, points.at(new Vec3(.5, 0, .69), Y).radiosity().g());
        assertEquals(2, points.at(new Vec3(.29, 0, .31), Y).irradiance().r(), 1e-12);
        assertEquals(2, points.at(new Vec3(.5, 0, .71), Y).irradiance().g(), 1e-12);
    }
}
