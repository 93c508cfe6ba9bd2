package radiosity.mesh.cut;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.mesh.face.Faces;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.testkit.Prism;
import radiosity.testkit.RoomScenes;

/** Faces are cut where others stand on them, and nowhere else. */
class DiscontinuityMesherTest {

    private static final Surface GREY = radiosity.testkit.RoomScenes.grey("grey", 0, 0.5);
    private static final double[] BASE = {.2, .3, .3, .6, .6, .5, .5, .2};

    private static SceneBuilder floor() {
        return new SceneBuilder()
                .polygon(GREY, new Vec3(0, 0, 0), new Vec3(0, 0, 1), new Vec3(1, 0, 1), new Vec3(1, 0, 0));
    }

    private static Faces cut(SceneBuilder builder) {
        return DiscontinuityMesher.cut(new Faces(builder.scene("cut")));
    }

    private static SceneBuilder wall(SceneBuilder builder, double from, double to) {
        Vec3[] p = {new Vec3(from, 0, .5), new Vec3(to, 0, .5), new Vec3(to, 1, .5), new Vec3(from, 1, .5)};
        return builder.polygon(GREY, p).polygon(GREY, p[3], p[2], p[1], p[0]);
    }

    @Test
    void whatTouchesNothing_staysAsItIs() {
        Faces whole = new Faces(floor().scene("floor"));
        assertSame(whole, DiscontinuityMesher.cut(whole));
    }

    @Test
    void pieces_haveTheAreaOfWhatTheyWere() {
        SceneBuilder builder = floor();
        new Prism(.5, BASE).addTo(builder, GREY);
        assertEquals(new Faces(builder.scene("block")).area(), cut(builder).area(), 1e-12);
    }

    /** Each piece of the floor has its middle either under a block or not, and no corner on the other side. */
    @ParameterizedTest
    @ValueSource(ints = {1, 14})
    void noPiece_liesHalfUnderABlock(int rows) {
        List<Prism> blocks = IntStream.range(0, rows * rows).mapToObj(i -> new Prism(.5, IntStream.range(0, 8)
                .mapToDouble(k -> (BASE[k] + (k % 2 == 0 ? i % rows : i / rows)) / rows).toArray())).toList();
        SceneBuilder builder = floor();
        blocks.forEach(block -> block.addTo(builder, GREY));
        Faces faces = cut(builder);
        assertTrue(IntStream.range(0, faces.count()).anyMatch(faces::isPiece));
        for (int f = 0; f < faces.count(); f++) {
            Vec3 middle = faces.sceneCorner(f, 0).plus(faces.sceneCorner(f, 1)).plus(faces.sceneCorner(f, 2))
                    .times(1 / 3.);
            for (int k = 0; k < 3 && faces.normal(f, 1) == 1 && middle.y() == 0; k++) {
                Vec3 nearCorner = faces.sceneCorner(f, k).times(.999).plus(middle.times(.001));
                assertEquals(isUnder(blocks, middle), isUnder(blocks, nearCorner));
            }
        }
    }

    private static boolean isUnder(List<Prism> blocks, Vec3 p) {
        return blocks.stream().anyMatch(block -> block.covers(p));
    }

    @Test
    void wholeWall_partsTheFloor() {
        assertEquals(2, partsOfTheFloor(cut(wall(floor(), 0, 1))).size());
    }

    /** Its ends can be walked round, but its two sides have vertices of their own. */
    @Test
    void freeWall_leavesTheFloorOnePartWithTwoSides() {
        Faces faces = cut(wall(floor(), .25, .75));
        assertEquals(1, partsOfTheFloor(faces).size());
        assertNotEquals(fanAtTheFoot(faces, true), fanAtTheFoot(faces, false));
    }

    private static Set<Integer> partsOfTheFloor(Faces faces) {
        Set<Integer> parts = new TreeSet<>();
        IntStream.range(0, faces.count()).filter(f -> faces.normal(f, 1) == 1).forEach(f -> parts.add(faces.part[f]));
        return parts;
    }

    /** Of the point where the wall crosses the floor's diagonal. */
    private static int fanAtTheFoot(Faces faces, boolean before) {
        for (int i = 0; i < 3 * faces.count(); i++) {
            Vec3 p = faces.sceneCorner(i / 3, i % 3);
            double middle = faces.sceneCorner(i / 3, 0).plus(faces.sceneCorner(i / 3, 1))
                    .plus(faces.sceneCorner(i / 3, 2)).z() / 3;
            if (faces.normal(i / 3, 1) == 1 && p.equals(new Vec3(.5, 0, .5)) && middle < .5 == before) {
                return faces.fan[i];
            }
        }
        throw new AssertionError("expected a vertex at the foot of the wall, found none");
    }

    /** A lamp with one visible side, .002 above the floor, from x = .1 to the given end and from z = .5 to .51. */
    private static SceneBuilder strip(double to, boolean down) {
        Vec3[] p = {new Vec3(.1, .002, .5), new Vec3(to, .002, .5), new Vec3(to, .002, .51), new Vec3(.1, .002, .51)};
        Surface lamp = RoomScenes.grey("lamp", 1, 0);
        return down ? floor().polygon(lamp, p) : floor().polygon(lamp, p[3], p[2], p[1], p[0]);
    }

    private static double[] acrossTheStrip(Faces faces) {
        return IntStream.range(0, 3 * faces.count()).filter(i -> faces.normal(i / 3, 1) == 1)
                .mapToObj(i -> faces.sceneCorner(i / 3, i % 3)).filter(p -> p.y() == 0 && p.x() > .2 && p.x() < .6)
                .mapToDouble(Vec3::z).map(z -> Math.round(z * 1e6) / 1e6).distinct().sorted().toArray();
    }

    /** Lines at 0, 1/2, 1, 2 and 4 heights from both edges; two of them meet the floor's diagonal only beyond .6. */
    @Test
    void longLampCloseToAFace_cutsTheFaceInBands() {
        Faces cut = cut(strip(.9, true));
        double[] found = acrossTheStrip(cut);
        assertEquals(List.of(.492, .496, .498, .499, .5, .501, .502, .504, .506, .508, .509, .51, .511, .512, .514, .518),
                java.util.Arrays.stream(found).boxed().toList());
        assertEquals(1 + .8 * .01, cut.area(), 1e-12);
    }

    /** As a rug has, too, and other things that do not shine on the face. */
    @Test
    void longEdgeOfWhatDoesNotShine_hasALineOnEitherSide() {
        double[] found = acrossTheStrip(cut(strip(.9, false)));
        assertEquals(List.of(.498, .502, .508, .512), java.util.Arrays.stream(found).boxed().toList());
    }

    @Test
    void shortEdge_leavesAFaceAsItIs() {
        Faces whole = new Faces(strip(.16, true).scene("short"));
        assertSame(whole, DiscontinuityMesher.cut(whole));
    }

    /** A long lamp below a row of boards, each of which is short beside its height above the lamp. */
    @Test
    void facesThatAreShortBesideALamp_areLeftAsTheyAre() {
        SceneBuilder boards = new SceneBuilder().polygon(RoomScenes.grey("lamp", 1, 0),
                new Vec3(.1, .002, .51), new Vec3(.9, .002, .51), new Vec3(.9, .002, .5), new Vec3(.1, .002, .5));
        for (int i = 0; i < 40; i++) {
            double x = .1 + i * .02;
            boards.polygon(GREY, new Vec3(x + .015, .004, .4), new Vec3(x + .015, .004, .6),
                    new Vec3(x, .004, .6), new Vec3(x, .004, .4));
        }
        Faces whole = new Faces(boards.scene("boards"));
        assertSame(whole, DiscontinuityMesher.cut(whole));
    }

    /** A bumpy wall as a scanner makes it: large facets at small angles, whose corners almost meet or do. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1e-6, 1e-5, 3e-5})
    void facetsOfAScan_areLeftAsTheyAre(double apart) {
        Random random = new Random(1);
        double[] bump = IntStream.range(0, 121).mapToDouble(i -> random.nextGaussian() * 1e-3).toArray();
        SceneBuilder wall = new SceneBuilder();
        for (int i = 0; i < 100; i++) {
            int at = i / 10 * 11 + i % 10;
            for (int[] corners : new int[][] {{at, at + 1, at + 12}, {at, at + 12, at + 11}}) {
                wall.polygon(GREY, Arrays.stream(corners).mapToObj(c -> new Vec3(c % 11 / 10.0, c / 11 / 10.0, bump[c])
                        .plus(new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
                        .times(apart))).toArray(Vec3[]::new));
            }
        }
        Faces whole = new Faces(wall.scene("wall"));
        assertSame(whole, DiscontinuityMesher.cut(whole));
    }

    /** A thousand black triangles through each other meet in more segments of one length than a mesh has elements. */
    @Tag("slow")
    @Test
    void whatWouldBePiecesOnly_staysAsItIs() {
        Random random = new Random(1);
        SceneBuilder soup = new SceneBuilder();
        for (int t = 0; t < 1000; t++) {
            soup.polygon(RoomScenes.grey("black", 0, 0), IntStream.range(0, 3).mapToObj(k -> new Vec3(
                    random.nextDouble(), random.nextDouble(), random.nextDouble())).toArray(Vec3[]::new));
        }
        Faces whole = new Faces(soup.scene("soup"));
        assertSame(whole, DiscontinuityMesher.cut(whole));
    }

    /** Window panes let into a wall, and so many small feet on the floor that not all contacts can be cut. */
    @Test
    @Tag("slow")
    void longContacts_areCutWhereShortOnesAreTooMany() {
        SceneBuilder room = new SceneBuilder();
        room.polygon(GREY, new Vec3(0, 0, 0), new Vec3(0, 0, 8), new Vec3(8, 0, 8), new Vec3(8, 0, 0));
        room.polygon(GREY, new Vec3(4, -1, 1), new Vec3(4, 1, 1), new Vec3(4, 1, 7), new Vec3(4, -1, 7));
        for (int i = 0; i < 6400; i++) {
            double x = .05 + i % 80 * .1;
            double z = .05 + i / 80 * .1;
            room.polygon(GREY, new Vec3(x, 0, z), new Vec3(x + .02, .1, z), new Vec3(x + .02, 0, z + .01));
        }
        Faces cut = DiscontinuityMesher.cut(new Faces(room.scene("room")));
        for (int f = 0; f < cut.count(); f++) {
            if (cut.normal(f, 1) == 1) {
                boolean before = false;
                boolean behind = false;
                for (int k = 0; k < 3; k++) {
                    Vec3 p = cut.sceneCorner(f, k);
                    boolean beside = p.z() > 1 && p.z() < 7;
                    before |= beside && p.x() < 4 - 1e-6;
                    behind |= beside && p.x() > 4 + 1e-6;
                }
                assertTrue(!before || !behind, "expected no face on both sides of the pane, got face " + f);
            }
        }
    }
}
