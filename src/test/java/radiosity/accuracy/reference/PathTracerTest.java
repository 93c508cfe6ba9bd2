package radiosity.accuracy.reference;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The path tracer against closed forms, and the stored references against the path tracer.
 *
 * <p>Furnace: radiosity is linear in emission, so the radiosities under each rectangle of a room as its only lamp, of
 * exitance 1, add up to that where all emit 1, and that is 1 / (1 - rho) in any closed room of reflectance rho. The
 * emitted part of it, 1, is not in the tracer's estimates.
 */
@Tag("slow")
class PathTracerTest {

    private static final long PATHS = 1 << 14;
    private static final double FOUR_ERRORS = 4;

    @ParameterizedTest
    @ValueSource(strings = {"blocks", "doorway"})
    void furnace_isTheClosedFormInEveryRoom(String name) {
        double rho = 0.5;
        Room room = Room.named(name);
        Room.Place place = room.places(ReferenceFile.POINTS, 1).get(7);
        double sum = 0;
        double variance = 0;
        for (int lamp = 0; lamp < room.rectangles().size(); lamp++) {
            PathTracer.Estimate found = new PathTracer(furnace(room, lamp, rho)).estimate(place, lamp, PATHS, PATHS, 0);
            sum += found.mean()[0];
            variance += found.standardError()[0] * found.standardError()[0];
        }
        double error = Math.sqrt(variance);
        assertTrue(error < 0.01, "standard error " + error);
        assertEquals(1 / (1 - rho) - 1, sum, FOUR_ERRORS * error);
    }

    private static Room furnace(Room room, int lamp, double rho) {
        double[] grey = {rho, rho, rho};
        Material wall = new Material("wall", new double[3], grey);
        Material light = new Material("lamp", new double[] {1, 1, 1}, grey);
        return new Room(room.name(), room.size(), IntStream.range(0, room.rectangles().size()).mapToObj(i -> {
            Rectangle r = room.rectangles().get(i);
            return new Rectangle(i == lamp ? light : wall, r.origin(), r.u(), r.v());
        }).toList());
    }

    /**
     * In a black room only the lamp is seen. Its configuration factor from a point straight below a corner of it is
     * (a / sqrt(1 + a²) atan(b / sqrt(1 + a²)) + b / sqrt(1 + b²) atan(a / sqrt(1 + b²))) / (2 pi) with a and b its
     * edges divided by the height (J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-3);
     * below its middle it is four times that of a quarter.
     */
    @Test
    void lightFromTheLampAlone_isTheClosedForm() {
        double rho = 0.5;
        Room dark = Room.twoRooms().with(m -> new Material(m.name(), m.exitance(), new double[3]));
        Rectangle floor = dark.rectangles().get(0);
        List<Rectangle> rectangles = new ArrayList<>(dark.rectangles());
        rectangles.set(0, new Rectangle(Material.wall("floor", rho, rho, rho), floor.origin(), floor.u(), floor.v()));
        PathTracer tracer = new PathTracer(new Room("lamp", 6, rectangles));
        PathTracer.Estimate found = tracer.estimate(new Room.Place(0, new double[] {1.3, 0, 2}), 1, 16 * PATHS,
                16 * PATHS, 0);
        double a = 0.5 / 2.6;
        double b = 0.8 / 2.6;
        double quarter = (part(a, b) + part(b, a)) / (2 * Math.PI);
        assertTrue(found.noise() < 0.001, "noise " + found.noise());
        assertEquals(rho * 12 * 4 * quarter, found.mean()[0], FOUR_ERRORS * found.standardError()[0]);
    }

    private static double part(double a, double b) {
        double root = Math.sqrt(1 + a * a);
        return a / root * Math.atan(b / root);
    }

    @ParameterizedTest
    @ValueSource(strings = {"blocks", "doorway"})
    void storedReferences_areWhatThePathTracerFinds(String name) throws IOException {
        Room room = Room.named(name);
        List<Room.Place> places = room.places(ReferenceFile.POINTS, ReferenceFile.SEED);
        List<ReferenceFile.Row> rows = ReferenceFile.rows(name);
        assertEquals(ReferenceFile.POINTS, rows.size());
        PathTracer tracer = new PathTracer(room);
        for (int i = 0; i < places.size(); i++) {
            ReferenceFile.Row row = rows.get(i);
            double[] position = {row.place()[0], row.place()[1], row.place()[2]};
            assertArrayEquals(places.get(i).position(), position, 1e-8, "point " + i);
            assertTrue(row.error()[3] <= ReferenceFile.NOISE * row.radiosity()[3], "noise of point " + i);
            if (i % 13 == 0) {
                PathTracer.Estimate found = tracer.estimate(places.get(i), 1000 + i, 8 * PATHS, 8 * PATHS, 0);
                for (int c = 0; c < 4; c++) {
                    double error = Math.hypot(found.standardError()[c], row.error()[c]);
                    assertEquals(row.radiosity()[c], found.mean()[c], FOUR_ERRORS * error, "point " + i);
                }
            }
        }
    }
}
