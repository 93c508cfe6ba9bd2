package radiosity.input.lightwave;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import radiosity.input.lightwave.lws.Turn;
import radiosity.scene.Affine;
import radiosity.scene.Scene;
import radiosity.scene.SceneNode;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;

/** W = W(parent) T(position) R(pivot rotation) Ry(h) Rx(p) Rz(b) S T(-pivot), in all the ways files write it. */
class PlacementTest {

    private static final String OBJECT1 = "LoadObject room.lwo\n";
    private static final String OBJECT3 = "LoadObjectLayer 1 room.lwo\n";

    @TempDir
    Path folder;

    private final List<String> told = new ArrayList<>();

    private Scene read(String text) throws IOException {
        Scene scene = Scenes.read(folder, text, ReadOptions.defaults(), told);
        assertEquals(List.of(), told);
        return scene;
    }

    private static void assertAt(double x, double y, double z, Vec3 got) {
        assertEquals(0, got.minus(new Vec3(x, y, z)).length(), 1e-12, got.toString());
    }

    @Test
    void headingPitchBank_turnAsLightWaveDoes() {
        double quarter = Math.PI / 2;
        assertDirection(1, 0, 0, Turn.of(quarter, 0, 0).direction(0, 0, 1));
        assertDirection(0, -1, 0, Turn.of(0, quarter, 0).direction(0, 0, 1));
        assertDirection(0, 1, 0, Turn.of(0, 0, quarter).direction(1, 0, 0));
        Affine all = Turn.of(0.3, 0.4, 0.5);
        Affine steps = Turn.of(0.3, 0, 0).times(Turn.of(0, 0.4, 0)).times(Turn.of(0, 0, 0.5));
        for (int i = 0; i < 12; i++) {
            assertEquals(steps.m()[i], all.m()[i], 1e-15);
        }
    }

    private static void assertDirection(double x, double y, double z, double[] got) {
        assertEquals(x, got[0], 1e-15);
        assertEquals(y, got[1], 1e-15);
        assertEquals(z, got[2], 1e-15);
    }

    @Test
    void positionAndScale_moveTheCorners() throws IOException {
        Scene scene = read("LWSC\n1\n" + OBJECT1 + Scenes.motion1(1, 2, 3, 0, 0, 0, 2, 4, 1));
        assertAt(1, 2, 3, Scenes.origin(scene, 0));
        assertAt(3, 6, 3, Scenes.far(scene, 0));
    }

    @Test
    void degreesAndRadians_areToldApart() throws IOException {
        Scene old = read("LWSC\n1\n" + OBJECT1 + Scenes.motion1(0, 0, 0, 0, 0, 90, 1, 1, 1));
        assertAt(-1, 1, 0, Scenes.far(old, 0));
        Scene recent = read("LWSC\n3\n" + OBJECT3
                + Scenes.motion3("ObjectMotion", 0, 0, 0, 0, 0, Math.PI / 2, 1, 1, 1));
        assertAt(-1, 1, 0, Scenes.far(recent, 0));
    }

    @Test
    void pivot_isThePointThatStaysWhenTurned() throws IOException {
        Scene old = read("LWSC\n1\n" + OBJECT1 + Scenes.motion1(5, 0, 0, 0, 0, 180, 1, 1, 1) + "PivotPoint 1 1 0\n");
        assertAt(5, 0, 0, Scenes.far(old, 0));
        assertAt(6, 1, 0, Scenes.origin(old, 0));
        Scene recent = read("LWSC\n3\n" + OBJECT3 + Scenes.motion3("ObjectMotion", 5, 0, 0, 0, 0, Math.PI, 1, 1, 1)
                + "PivotPosition 1 1 0\n");
        assertAt(6, 1, 0, Scenes.origin(recent, 0));
    }

    @Test
    void pivotOfTheLayer_holdsWhereTheSceneHasNone() throws IOException {
        Files.write(folder.resolve("p.lwo"), Iff.form("LWO2", Iff.chunk("TAGS", Iff.s0("white")),
                Iff.chunk("LAYR", Iff.u2(0, 0), Iff.f4(1, 1, 0), Iff.s0("")), Objects.squareOf("FACE"),
                Objects.lwo2Surface("white", "")));
        assertAt(-1, -1, 0, Scenes.origin(read("LWSC\n3\nLoadObjectLayer 1 p.lwo\n"), 0));
        assertAt(-2, 0, 0, Scenes.origin(read("LWSC\n3\nLoadObjectLayer 1 p.lwo\nPivotPosition 2 0 0\n"), 0));
        assertAt(0, 0, 0, Scenes.left(LightWaveReader.read(folder.resolve("p.lwo"), ReadOptions.defaults(),
                told::add)
                .corner(0, 0)));
    }

    @Test
    void pivotRotation_isInDegreesInEveryVersion() throws IOException {
        Scene scene = read("LWSC\n3\n" + OBJECT3 + "PivotRotation 0 0 90\n");
        assertAt(-1, 1, 0, Scenes.far(scene, 0));
    }

    /** Its z axis points there, in all versions. */
    @Test
    void objectWithATarget_isTurnedTowardsIt() throws IOException {
        String away = Scenes.motion1(10, 0, 0, 0, 0, 0, 1, 1, 1);
        assertAt(0, 1, -1, Scenes.far(read("LWSC\n1\n" + OBJECT1 + Scenes.motion1(0, 0, 0, 30, 40, 0, 1, 1, 1)
                + "TargetObject 2\nAddNullObject n\n" + away), 0));
        assertAt(0, 1, -1, Scenes.far(read("LWSC\n3\n" + OBJECT3 + "TargetItem 10000001\nPivotRotation 0 0 90\n"
                + "AddNullObject n\n" + Scenes.motion3("ObjectMotion", 10, 0, 0, 0, 0, 0, 1, 1, 1)), 0));
    }

    @Test
    void whatFollowsAnAimedLight_isTurnedWithIt() throws IOException {
        Scene scene = read("LWSC\n3\n" + OBJECT3 + "ParentItem 20000000\nAddNullObject n\n"
                + Scenes.motion3("ObjectMotion", 10, 0, 0, 0, 0, 0, 1, 1, 1) + "AddLight\n"
                + Scenes.motion3("LightMotion", 0, 0, 5, 0, 0, 0, 1, 1, 1) + "LightType 2\nTargetItem 10000001\n");
        double flat = Math.hypot(10, 5);
        assertAt(-5 / flat, 1, 5 - 10 / flat, Scenes.far(scene, 0));
    }

    /** Each is aimed at the next, or at what it carries itself. */
    @Test
    void circlesAndLongChainsOfTargets_end() throws IOException {
        StringBuilder chain = new StringBuilder("LWSC\n3\n");
        for (int i = 0; i < 20_000; i++) {
            chain.append("AddNullObject n\nTargetItem ").append(Integer.toHexString(0x10000001 + i)).append('\n');
        }
        Scenes.read(folder, chain + OBJECT3 + "TargetItem 10000000\n", ReadOptions.defaults(), told);
        assertTrue(told.get(0).contains("long chains of targets"), told.toString());
        told.clear();
        assertAt(1, 1, 0, Scenes.far(read("LWSC\n3\n" + OBJECT3 + "TargetItem 10000001\nAddNullObject n\n"
                + "ParentItem 10000000\n"), 0));
    }

    @Test
    void child_isPlacedInTheSpaceOfItsParentsPoints() throws IOException {
        String parent = Scenes.motion1(10, 0, 0, 0, 0, 90, 2, 2, 2) + "PivotPoint 1 0 0\n";
        Scene scene = read("LWSC\n1\n" + OBJECT1 + parent + OBJECT1 + Scenes.motion1(1, 0, 0, 0, 0, 0, 1, 1, 1)
                + "ParentObject 1\n");
        assertAt(10, 0, 0, Scenes.origin(scene, 1));
        assertAt(8, 2, 0, Scenes.far(scene, 1));
    }

    @Test
    void tabs_divideWordsAsBlanksDo() throws IOException {
        assertAt(0, 0, 0, Scenes.origin(read("LWSC\n3\nLoadObjectLayer\t1\troom.lwo\n"), 0));
        Scene scene = read("LWSC\n5\nLoadObjectLayer\t1\t10000005 \troom.lwo\nParentItem\t10000003\n"
                + "AddNullObject\t10000003\ta null\tobject\n" + Scenes.motion3("ObjectMotion", 7));
        assertAt(7, 0, 0, Scenes.origin(scene, 0));
        assertEquals(List.of("a null\tobject", "room"),
                scene.hierarchy().nodes().stream().map(SceneNode::name).toList());
    }

    @Test
    void parents_areFoundByEveryNumbering() throws IOException {
        String moved = "{ Envelope\n 1\n Key 7 0 0 0 0 0\n}\n";
        String motion = "ObjectMotion\nNumChannels 1\nChannel 0\n" + moved;
        String nullObject = Scenes.motion1(7, 0, 0, 0, 0, 0, 1, 1, 1);
        assertAt(7, 0, 0, Scenes.origin(read("LWSC\n1\n" + OBJECT1 + "ParentObject 2\nAddNullObject n\n" + nullObject),
                0));
        assertAt(7, 0, 0, Scenes.origin(read("LWSC\n3\n" + OBJECT3 + "ParentItem 10000001\nAddNullObject n\n" + motion),
                0));
        assertAt(7, 0, 0, Scenes.origin(read("LWSC\n5\nLoadObjectLayer 1 10000005 room.lwo\nParentItem 10000003\n"
                + "AddNullObject 10000003 n\n" + motion), 0));
        assertAt(7, 0, 0, Scenes.origin(read("LWSC\n4\nLoadObjectLayer 1 10000000 room.lwo\nParentItem 20000000\n"
                + "AddLight 20000000\nLightMotion\nNumChannels 1\nChannel 0\n" + moved), 0));
    }

    @Test
    void boneAsParent_standsForItsObject() throws IOException {
        Scene scene = Scenes.read(folder, "LWSC\n5\nLoadObjectLayer 1 10000000 room.lwo\n"
                + Scenes.motion3("ObjectMotion", 3) + "AddBone 40020000\nBoneName b\n" + Scenes.motion3("BoneMotion", 9)
                + "LoadObjectLayer 1 10000001 room.lwo\nParentItem 40020000\n", ReadOptions.defaults(), told);
        assertAt(3, 0, 0, Scenes.origin(scene, 1));
        assertTrue(told.get(0).contains("bones"), told.toString());
    }

    @Test
    void mirroredObject_keepsItsVisibleSide() throws IOException {
        Scene scene = read("LWSC\n1\n" + OBJECT1 + OBJECT1 + Scenes.motion1(0, 0, 0, 0, 0, 0, -1, 1, 1));
        assertEquals(1, normal(scene, 0).z(), 1e-12, "seen from -z in LightWave, so from +z here");
        assertEquals(1, normal(scene, 2).z(), 1e-12, "mirrored in x, still seen from there");
    }

    private static Vec3 normal(Scene scene, int t) {
        return scene.corner(t, 1).minus(scene.corner(t, 0)).cross(scene.corner(t, 2).minus(scene.corner(t, 0)));
    }

    @Test
    void frame_isTheScenesFirstUnlessGiven() throws IOException {
        String text = "LWSC\n1\nFirstFrame 10\nFramesPerSecond 25\n" + OBJECT1 + "ObjectMotion (unnamed)\n 9\n 2\n"
                + " 0 0 0 0 0 0 1 1 1\n 0 1 0 0 0\n 40 0 0 0 0 0 1 1 1\n 40 1 0 0 0\nEndBehavior 1\n";
        assertAt(10, 0, 0, Scenes.origin(read(text), 0));
        assertAt(25, 0, 0, Scenes.origin(Scenes.read(folder, text, ReadOptions.defaults().withFrame(25), told),
                0));
    }

    @Test
    void times_areFramesInVersion1AndSecondsLater() throws IOException {
        String by = "ObjectMotion\nNumChannels 9\nChannel 0\n{ Envelope\n 2\n Key 0 0 3 0 0 0\n Key 40 2 3 0 0 0\n}\n";
        assertAt(10, 0, 0, Scenes.origin(read("LWSC\n3\nFirstFrame 10\nFramesPerSecond 20\n" + OBJECT3 + by), 0));
        String byChannel = "ObjectMotion (unnamed)\n 9\n 2\n 0 0 3 0 0 0\n 40 2 3 0 0 0\n"
                + " 1\n 5 0 2 0 0 0\n 1\n 0 0 2 0 0 0\n 1\n 0 0 2 0 0 0\n 1\n 0 0 2 0 0 0\n 1\n 90 0 2 0 0 0\n"
                + " 1\n 1 0 2 0 0 0\n 1\n 1 0 2 0 0 0\n 1\n 1 0 2 0 0 0\nPre/PostBehavior 1 1 1 1\n";
        Scene scene = read("LWSC\n2\nFirstFrame 10\nFramesPerSecond 20\n" + OBJECT1 + byChannel);
        assertAt(10, 5, 0, Scenes.origin(scene, 0));
        assertAt(9, 6, 0, Scenes.far(scene, 0));
    }

    @Test
    void dissolvedObject_isNotThere() throws IOException {
        String envelope = "ObjDissolve (envelope)\n 1\n 1\n 1\n 0 0 0 0 0\nEndBehavior 1\n";
        assertEquals(2, read("LWSC\n1\n" + OBJECT1 + OBJECT1 + "ObjDissolve 1\n").triangles());
        assertEquals(2, read("LWSC\n1\n" + OBJECT1 + OBJECT1 + envelope).triangles());
        assertEquals(4, read("LWSC\n1\n" + OBJECT1 + OBJECT1 + "ObjDissolve 0.9\n").triangles());
        String afterBone = "AddBone\nBoneName b\nBoneMotion (unnamed)\n 9\n 1\n 0 0 0 0 0 0 1 1 1\n 0 0 0 0 0\n"
                + "EndBehavior 1\nObjDissolve 1\n";
        assertEquals(2, Scenes.read(folder, "LWSC\n1\n" + OBJECT1 + OBJECT1 + afterBone, ReadOptions.defaults(),
                told).triangles());
    }
}
