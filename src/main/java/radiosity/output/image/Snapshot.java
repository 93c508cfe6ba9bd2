package radiosity.output.image;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import radiosity.output.mesh.Elements;
import radiosity.output.mesh.SmoothShading;
import radiosity.output.mesh.TJunctions;
import radiosity.output.raytrace.EyeRays;
import radiosity.scene.Camera;
import radiosity.scene.Rgb;
import radiosity.scene.Units;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.util.Aabb;
import radiosity.util.ArraySize;
import radiosity.util.ParallelFor;
import radiosity.visibility.RadiosityBounds;
import radiosity.visibility.ScaledBounds;

/**
 * Draws a picture of a solution without a display: rays through the pixels, radiosity interpolated on elements.
 *
 * <p>A surface is seen from its visible side only and transparent from behind, as in every viewer of the scene file.
 * The background is black. {@link EyeRays} trace the light further if surfaces shine or light is gathered.
 */
public final class Snapshot {

    /** Samples per pixel along each axis. */
    private static final int SAMPLES = 3;

    private final Solution solution;
    private final Vec3 eye;
    /** The elements that face the eye: only these elements can be seen. */
    private final int[] facing;
    private final ScaledBounds scaled;
    private final int gathered;
    /** Null if pictures show the radiosity of the solution alone. */
    private final EyeRays rays;

    /**
     * How a picture is drawn.
     *
     * @param gathered rays per pixel that gather the arriving light, so that no mesh shows; 0 to interpolate light
     *                 between the mesh's vertices
     * @param threads  number of threads that draw, at least 1
     * @param progress is given the part of the picture that is done, by several threads at once
     */
    public record Drawing(int gathered, int threads, Progress progress) {

        /** Largest number of gathering rays per pixel. */
        public static final int MOST_GATHERED = 1_000_000;

        public Drawing {
            if (gathered < 0 || gathered > MOST_GATHERED) {
                throw new IllegalArgumentException("gathered rays: expected a number from 0 to " + MOST_GATHERED
                        + ", got " + gathered);
            }
        }

        /** Draws on one thread per processor. */
        public Drawing(int gathered, Progress progress) {
            this(gathered, Runtime.getRuntime().availableProcessors(), progress);
        }

        /** Decides whether drawing goes on; otherwise the drawing ends with a {@link CancellationException}. */
        public interface Progress {

            /** @param done part of the pixels, in (0, 1] */
            boolean goesOn(double done);
        }
    }

    /** @param closed with T-junctions closed; its irradiance is interpolated on elements */
    private Snapshot(Solution closed, Vec3 eye, int gathered) {
        solution = closed;
        this.gathered = gathered;
        int perRay = (gathered + SAMPLES * SAMPLES - 1) / (SAMPLES * SAMPLES);
        rays = gathered > 0 || EyeRays.shines(solution) ? new EyeRays(solution, perRay) : null;
        this.eye = eye;
        facing = IntStream.range(0, solution.elements()).filter(this::faces).toArray();
        scaled = new ScaledBounds(Aabb.of(solution.positions()), facing.length,
                i -> Elements.corner(solution, facing[i / 3], i % 3));
    }

    private boolean faces(int element) {
        return Elements.cross(solution, element).dot(eye.minus(Elements.corner(solution, element, 0))) > 0;
    }

    /**
     * Writes a picture in the format that the end of the file's name stands for.
     *
     * @param width       pixels; the height follows from the camera's aspect
     * @param toneMapping for .png and .jpg; a .hdr holds radiosity as it is, in W/m² or lm/m²
     * @throws CancellationException if the progress of the drawing ended it; nothing is written then
     */
    public static void write(Path file, Solution solution, Camera camera, int width, ToneMapping toneMapping,
                             Drawing drawing) throws IOException {
        PictureFormat format = PictureFormat.of(file);
        boolean mapped = format != PictureFormat.HDR;
        format.write(file, take(solution, camera, width, mapped ? toneMapping::map : UnaryOperator.identity(),
                drawing), solution.scene().units());
    }

    /** Whether a surface of a solution mirrors or transmits light, so that drawing takes longer. */
    public static boolean isTraced(Solution solution) {
        return EyeRays.shines(solution);
    }

    /** Height in pixels of a picture of a given width, at least 1. */
    public static long height(Camera camera, int width) {
        return Math.max(1, Math.round(width / camera.aspect()));
    }

    /** @param film maps the radiosity of each sample, before the samples of a pixel are averaged */
    static Picture take(Solution solution, Camera camera, int width, UnaryOperator<Rgb> film, Drawing drawing) {
        long rows = height(camera, width);
        float[] rgb = new float[ArraySize.of("picture of " + width + "x" + rows + " pixels", 3, width, rows)];
        int height = (int) rows;
        Snapshot snapshot = new Snapshot(SmoothShading.shown(TJunctions.close(solution)), camera.position(),
                drawing.gathered);
        AtomicLong done = new AtomicLong();
        new ParallelFor(drawing.threads).run(height, row -> {
            for (int column = 0; column < width; column++) {
                long drawn = done.incrementAndGet();
                if ((column == 0 || drawing.gathered > 0)
                        && !drawing.progress.goesOn((double) drawn / ((long) width * height))) {
                    throw new CancellationException();
                }
                Rgb pixel = snapshot.pixel(camera, column, row, width, height, film);
                int i = 3 * (row * width + column);
                rgb[i] = (float) pixel.r();
                rgb[i + 1] = (float) pixel.g();
                rgb[i + 2] = (float) pixel.b();
            }
        });
        return new Picture(width, height, rgb);
    }

    /**
     * The light that arrives at the surfaces that are seen.
     *
     * @param value irradiance (W/m²) or illuminance (lx), one per sample, from the upper left; NaN where nothing is
     *              seen
     * @param plane one per sample: equal for samples that lie in one plane
     */
    record Values(int width, int height, float[] value, int[] plane) { }

    /**
     * Draws the light that arrives, with one sample per pixel.
     *
     * @param threads number of threads that draw, at least 1
     */
    static Values irradiance(Solution solution, Camera camera, int width, int threads) {
        int height = (int) height(camera, width);
        int size = ArraySize.of("picture of " + width + "x" + height + " pixels", width, height);
        Values values = new Values(width, height, new float[size], new int[size]);
        Snapshot snapshot = new Snapshot(TJunctions.close(solution), camera.position(), 0);
        Units units = solution.scene().units();
        new ParallelFor(threads).run(height, row -> {
            float[] hit = new float[3];
            for (int column = 0; column < width; column++) {
                int element = snapshot.element(camera.direction(2 * (column + 0.5) / width - 1,
                        1 - 2 * (row + 0.5) / height), hit);
                int i = row * width + column;
                values.value[i] = element < 0 ? Float.NaN
                        : (float) units.total(Elements.irradiance(snapshot.solution, element, hit[1], hit[2]));
                values.plane[i] = element < 0 ? 0 : snapshot.plane(element);
            }
        });
        return values;
    }

    private int plane(int element) {
        Vec3 n = Elements.normal(solution, element);
        double offset = n.dot(scaled.unit(Elements.corner(solution, element, 0)));
        return Arrays.hashCode(new long[] {Math.round(n.x() * 64), Math.round(n.y() * 64), Math.round(n.z() * 64),
            Math.round(offset * 1024)});
    }

    private Rgb pixel(Camera camera, int column, int row, int width, int height, UnaryOperator<Rgb> film) {
        double r = 0;
        double g = 0;
        double b = 0;
        Rgb[] seen = rays == null ? null : seen(camera, column, row, width, height);
        for (int s = 0; s < SAMPLES * SAMPLES; s++) {
            Rgb light = film.apply(seen == null ? along(direction(camera, column, row, width, height, s)) : seen[s]);
            r += light.r();
            g += light.g();
            b += light.b();
        }
        return new Rgb(r, g, b).times(1.0 / (SAMPLES * SAMPLES));
    }

    /** Unit direction from the eye through sample s of a pixel. */
    private static Vec3 direction(Camera camera, int column, int row, int width, int height, int s) {
        double x = 2 * (column + (s % SAMPLES + 0.5) / SAMPLES) / width - 1;
        double y = 1 - 2 * (row + (s / SAMPLES + 0.5) / SAMPLES) / height;
        return camera.direction(x, y);
    }

    /** Radiosity of the element that a ray from the eye meets, W/m²; black without an element. */
    private Rgb along(Vec3 direction) {
        float[] hit = new float[3];
        int element = element(direction, hit);
        return element < 0 ? Rgb.BLACK : radiosity(element, hit[1], hit[2]);
    }

    /**
     * The element that a ray from the eye meets, or -1. A far ray begins near the scene, where floats are exact.
     *
     * @param hit receives the distance and the weights of corners 1 and 2
     */
    private int element(Vec3 direction, float[] hit) {
        Vec3 from = scaled.unit(eye);
        double skipped = Math.max(0, from.length() - 1);
        Vec3 o = from.plus(direction.times(skipped));
        int found = scaled.bounds.nearest(o, direction, RadiosityBounds.ACROSS, hit);
        return found < 0 ? -1 : facing[found];
    }

    /** Light seen along each ray of a pixel, traced beyond the first element; gathered once per triangle met. */
    private Rgb[] seen(Camera camera, int column, int row, int width, int height) {
        Vec3[] directions = IntStream.range(0, SAMPLES * SAMPLES)
                .mapToObj(s -> direction(camera, column, row, width, height, s)).toArray(Vec3[]::new);
        long first = EyeRays.number(column, row) * directions.length;
        int[] element = new int[directions.length];
        float[][] hit = new float[directions.length][3];
        for (int s = 0; s < directions.length; s++) {
            element[s] = element(directions[s], hit[s]);
        }
        Rgb[] seen = new Rgb[directions.length];
        for (int s = 0; s < directions.length; s++) {
            if (seen[s] == null && element[s] >= 0 && gathered > 0
                    && solution.surface(element[s]).specular().isEmpty()) {
                gather(element, hit, s, first, seen);
            } else if (seen[s] == null) {
                seen[s] = element[s] < 0 ? Rgb.BLACK
                        : rays.seen(element[s], eye, directions[s], first + s);
            }
        }
        return seen;
    }

    /** Gathers light once for all rays of a pixel that meet the same side of the same triangle as a given ray. */
    private void gather(int[] element, float[][] hit, int ray, long first, Rgb[] seen) {
        int face = solution.faceOf()[element[ray]];
        int[] same = IntStream.range(ray, element.length)
                .filter(s -> element[s] >= 0 && solution.faceOf()[element[s]] == face).toArray();
        Vec3 sum = Vec3.ZERO;
        for (int s : same) {
            sum = sum.plus(Elements.point(solution, element[s], hit[s][1], hit[s][2]));
        }
        Rgb irradiance = rays.irradiance(element[ray], sum.times(1.0 / same.length), first + ray, same.length);
        for (int s : same) {
            seen[s] = solution.scene().material(face >> 1, Elements.point(solution, element[s], hit[s][1], hit[s][2]))
                    .radiosity(irradiance);
        }
    }

    private Rgb radiosity(int element, double v, double w) {
        return solution.scene().material(solution.faceOf()[element] >> 1, Elements.point(solution, element, v, w))
                .radiosity(Elements.irradiance(solution, element, v, w));
    }
}
