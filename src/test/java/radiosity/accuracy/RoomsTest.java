package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.testkit.Moves;
import radiosity.testkit.Polyhedra;
import radiosity.testkit.RoomScenes;

/**
 * The rooms of the accuracy tests are what they claim: along every edge of a closed room two triangles run in opposite
 * directions, and by the divergence theorem its volume, sum of p0 . (p1 x p2) / 6, is negative where it is seen from
 * inside.
 */
class RoomsTest {

    private static final Surface WALL = RoomScenes.grey("wall", 1, 0.5);

    static List<Scene> closed() {
        List<Scene> rooms = new ArrayList<>();
        RoomScenes.watertight().values().forEach(room -> rooms.add(room.apply(WALL)));
        for (long seed = 0; seed < 50; seed++) {
            rooms.add(Polyhedra.random(seed, WALL));
        }
        rooms.add(Cie.cube(0.5));
        return rooms;
    }

    @Test
    void closedRooms_matchAlongEveryEdge() {
        for (Scene room : closed()) {
            Set<Long> edges = new HashSet<>();
            for (int t = 0; t < room.triangles(); t++) {
                for (int k = 0; k < 3; k++) {
                    assertTrue(edges.add(edge(room, t, k, (k + 1) % 3)), () -> room.name() + " has a double edge");
                }
            }
            for (int t = 0; t < room.triangles(); t++) {
                for (int k = 0; k < 3; k++) {
                    assertTrue(edges.contains(edge(room, t, (k + 1) % 3, k)), () -> room.name() + " is open");
                }
            }
        }
    }

    private static long edge(Scene room, int t, int from, int to) {
        return (long) room.corners()[3 * t + from] << 32 | room.corners()[3 * t + to];
    }

    @Test
    void closedRooms_areSeenFromInside() {
        for (Scene room : closed()) {
            assertTrue(volume(room) < 0, room.name());
        }
    }

    @Test
    void rooms_haveTheVolumeOfTheirShape() {
        Map<String, Double> volumes = Map.of("cube", 1., "corridor", 50., "L-shaped room", 36.,
                "room with blocks", 60 - 1.7 * 0.9 - 1.2 * 0.8 * 0.9, "room with a floating cube", 26.);
        volumes.forEach((name, volume) ->
                assertEquals(-volume, volume(RoomScenes.watertight().get(name).apply(WALL)), 1e-12, name));
    }

    private static double volume(Scene room) {
        double sum = 0;
        for (int t = 0; t < room.triangles(); t++) {
            sum += room.corner(t, 0).dot(room.corner(t, 1).cross(room.corner(t, 2))) / 6;
        }
        return sum;
    }

    @Test
    void reorderedScene_hasTheSameTriangles() {
        Scene room = Cie.cube(0.5);
        Scene other = Moves.reordered(room, 1);
        assertEquals(volume(room), volume(other), 1e-12);
        assertEquals(lampArea(room), lampArea(other), 1e-12);
    }

    private static double lampArea(Scene room) {
        double sum = 0;
        for (int t = 0; t < room.triangles(); t++) {
            sum += room.surface(t).emits() ? room.area(t) : 0;
        }
        return sum;
    }
}
