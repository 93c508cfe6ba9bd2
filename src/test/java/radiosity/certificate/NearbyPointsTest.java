package radiosity.certificate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.face.Faces;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.setup.InitialMesh;
import radiosity.testkit.Box;
import radiosity.testkit.RoomScenes;
import radiosity.util.ParallelFor;

/** Errors that go to and fro across a gap are followed; those of surfaces far away are not. */
class NearbyPointsTest {

    private static final double REFLECTANCE = .8;

    /**
     * A slot without any light, of which a solution says that light of 1 W/m² arrives at every point: .8 of it is found
     * by who looks there once, so .2 are wrong. Of the rest, .8 again after every step across the slot.
     */
    @Test
    void wrongLightInASlot_isFoundByWhatItIsAfterThreeSteps() {
        List<AuditPoint> points = looked(.002);
        double residual = 1 - REFLECTANCE;
        double known = residual * (1 + REFLECTANCE + Math.pow(REFLECTANCE, 2) + Math.pow(REFLECTANCE, 3));
        long whole = points.stream().filter(p -> Math.abs(p.error(0) - REFLECTANCE * known) < 1e-9).count();
        // one ray in a thousand leaves the slot below an element without meeting its other side
        assertTrue(whole >= .9 * points.size(), whole + " of " + points.size());
    }

    /** Elements of a cube are an eighth of its edges long: only beside an edge another wall is nearer than that. */
    @Test
    void errorsAcrossARoom_areNotFollowed() {
        List<AuditPoint> points = looked(1);
        long once = points.stream()
                .filter(p -> Math.abs(p.error(0) - REFLECTANCE * (1 - REFLECTANCE)) < 1e-9).count();
        assertTrue(once >= .7 * points.size() && once < points.size(), once + " of " + points.size());
    }

    @Test
    void place_isInTheSmallestNodeAroundIt() {
        double[] weight = {.7, .1, .2};
        NearbyPoints.Place place = NearbyPoints.Place.of(3, weight);
        assertEquals(1.0, Arrays.stream(place.weights(1)).sum(), 1e-12);
        assertEquals(.4, place.weights(0b100)[0], 1e-12);
        assertEquals(0b100, place.path() >> 2 * 29);
    }

    /** Points of a box as high as given, on meshes of some 800 elements, at which .8 is found for 1. */
    private static List<AuditPoint> looked(double height) {
        SceneBuilder builder = new SceneBuilder();
        Box box = new Box(Vec3.ZERO, new Vec3(1, 1, height));
        for (int side = 0; side < 6; side++) {
            builder.polygon(RoomScenes.grey("wall", 0, REFLECTANCE), box.inside(side));
        }
        Scene scene = builder.scene("box");
        InitialMesh mesh = new InitialMesh(scene, new RadiositySettings(scene.area() / 800, 0,
                RadiositySettings.defaults().meshing(), RadiositySettings.defaults().schedule()));
        Faces faces = mesh.faces;
        ParallelFor parallel = new ParallelFor(1);
        IntFunction<RadiosityNodes> nodes = block -> {
            RadiosityNodes its = new RadiosityNodes(mesh.patcher, List.of(mesh.blocks.get(block)));
            Arrays.fill(its.light().irradiance(), 1);
            return its;
        };
        AuditPlaces places = new AuditPlaces(mesh, nodes, new double[] {1}, new double[] {1}, parallel);
        List<AuditPoint> points = places.pick(200, .5, 0);
        List<NearbyPoints.Near> near = new NearbyPoints(faces, mesh.bounds, places).around(points);
        AuditGather gather = new AuditGather();
        points.forEach(point -> point.gather(gather, 0));
        near.forEach(it -> it.point().gather(gather, 0, it.time()));
        int count = gather.points(new int[mesh.blocks.size()]).count();
        ByteBuffer found = ByteBuffer.allocate(count * (Integer.BYTES + Double.BYTES));
        for (int i = 0; i < count; i++) {
            found.putInt(i).putDouble(REFLECTANCE);
        }
        gather.take(List.of(found.array()));
        return points;
    }
}
