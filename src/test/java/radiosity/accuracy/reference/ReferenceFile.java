package radiosity.accuracy.reference;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * The file of reference radiosities of two rooms, {@value #FILE}. Made anew by, after {@code mvn test-compile}:
 *
 * <pre>java -cp target/test-classes:target/classes radiosity.accuracy.reference.ReferenceFile</pre>
 */
final class ReferenceFile {

    static final int POINTS = 40;
    static final long SEED = 20;
    /** Largest standard error of the mean of a point's colours, relative to that mean. */
    static final double NOISE = 0.003;

    private static final String FILE = "src/test/resources/radiosity/accuracy/reference/rooms.csv";
    private static final String COMMAND =
            "java -cp target/test-classes:target/classes " + ReferenceFile.class.getName();
    private static final long FEWEST_PATHS = 1 << 15;
    private static final long MOST_PATHS = 1 << 24;

    private ReferenceFile() { }

    /**
     * One point of the file.
     *
     * @param place     x, y, z in m, and the normal; 6 values
     * @param radiosity of red, green, blue, and of their mean, W/m²
     * @param error     standard error of each, W/m²
     */
    record Row(double[] place, double[] radiosity, double[] error) { }

    /** Writes the file and prints the noise and cost of each point. */
    public static void main(String[] arguments) throws IOException {
        StringBuilder text = new StringBuilder(String.format(Locale.ROOT, """
                # Radiosities in W/m2 at points of the rooms of radiosity.accuracy.reference.Room, with standard errors.
                # Path traced with seed %d to a standard error of at most %.1f %% of the mean of a point's colours, by
                # %s
                room,x,y,z,nx,ny,nz,B_r,B_g,B_b,B_mean,se_r,se_g,se_b,se_mean,paths
                """, SEED, 100 * NOISE, COMMAND));
        for (Room room : List.of(Room.withBlocks(), Room.twoRooms())) {
            PathTracer tracer = new PathTracer(room);
            int point = 0;
            for (Room.Place place : room.places(POINTS, SEED)) {
                PathTracer.Estimate found = tracer.estimate(place, SEED + point++, FEWEST_PATHS, MOST_PATHS, NOISE);
                text.append(line(room, place, found));
                System.out.printf(Locale.ROOT, "%s %d: %.2f %% after %d paths%n", room.name(), point,
                        100 * found.noise(), found.paths());
            }
        }
        Files.createDirectories(Path.of(FILE).getParent());
        Files.writeString(Path.of(FILE), text);
    }

    private static String line(Room room, Room.Place place, PathTracer.Estimate found) {
        StringBuilder line = new StringBuilder(room.name());
        for (double x : place.position()) {
            line.append(String.format(Locale.ROOT, ",%.9f", x));
        }
        for (double x : room.rectangles().get(place.on()).normal()) {
            line.append(String.format(Locale.ROOT, ",%.9f", x));
        }
        for (double[] values : new double[][] {found.mean(), found.standardError()}) {
            for (double x : values) {
                line.append(String.format(Locale.ROOT, ",%.6g", x));
            }
        }
        return line.append(',').append(found.paths()).append('\n').toString();
    }

    /** The points of a room, in the order of {@link Room#places}. */
    static List<Row> rows(String room) throws IOException {
        List<Row> rows = new ArrayList<>();
        try (InputStream in = ReferenceFile.class.getResourceAsStream("rooms.csv")) {
            for (String line : new String(in.readAllBytes(), StandardCharsets.US_ASCII).lines().toList()) {
                String[] words = line.split(",");
                if (words[0].equals(room)) {
                    rows.add(new Row(numbers(words, 1, 6), numbers(words, 7, 4), numbers(words, 11, 4)));
                }
            }
        }
        return rows;
    }

    private static double[] numbers(String[] words, int first, int count) {
        double[] numbers = new double[count];
        for (int i = 0; i < count; i++) {
            numbers[i] = Double.parseDouble(words[first + i]);
        }
        return numbers;
    }
}
