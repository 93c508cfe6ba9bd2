package radiosity.output.image;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import radiosity.output.mesh.Elements;
import radiosity.scene.Camera;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.util.Aabb;
import radiosity.visibility.RadiosityBounds;
import radiosity.visibility.ScaledBounds;

/** Scores how much of a lit scene a camera shows, by a few rays against the original triangles. */
final class LitView {

    /** Largest number of rays across and down a picture. */
    static final int COLUMNS = 48;
    static final int ROWS = 36;
    /** How often a ray may pass through the back of a one-sided surface. */
    private static final int PASSES = 16;
    /** Least cosine of incidence that a surface counts with, so that a sliver seen along its length adds little. */
    private static final double GRAZING = 0.1;
    /** How far behind a surface a ray goes on, and how far off a surface a lit place lies, of the scene's diagonal. */
    private static final double STEP = 1e-5;
    private static final double OFF = 1e-4;
    /** A view keeps its score while its largest object fills at most OBJECT of it, and LEFT of it at LARGE_OBJECT. */
    private static final double OBJECT = 0.2;
    private static final double LARGE_OBJECT = 1.0 / 3;
    private static final double LEFT = 0.1;
    /** Surfaces nearer than this share of the mean distance are in the way. */
    private static final double NEAR = 0.3;
    /** Share of its score that a view straight up loses. */
    private static final double LOOKING_UP = 0.4;

    private final Scene scene;
    private final ScaledBounds scaled;
    /** 1 per side of a triangle: mean luminance over that of the scene, at most 1; 1 on all sides if nothing is lit. */
    private final double[] lit;
    private final Vec3[] normals;
    private final PrincipalAxes axes;
    private final SceneObjects objectsOf;
    private final float[] weights = new float[3];

    LitView(Solution solution) {
        scene = solution.scene();
        Aabb box = Aabb.of(scene.points());
        normals = new Vec3[scene.triangles()];
        Arrays.setAll(normals, t -> scene.cross(t).unit());
        scaled = new ScaledBounds(box, scene.triangles(), i -> scene.corner(i / 3, i % 3));
        lit = lit(solution);
        axes = PrincipalAxes.of(scene);
        objectsOf = new SceneObjects(scene, axes, box.diagonal());
    }

    private static double[] lit(Solution solution) {
        double[] light = new double[2 * solution.scene().triangles()];
        double[] area = new double[light.length];
        double lightSum = 0;
        double areaSum = 0;
        for (int e = 0; e < solution.elements(); e++) {
            double a = Elements.cross(solution, e).length();
            double l = a * Math.max(0, ToneMapping.luminance(solution.radiosityAt(e, 0)));
            light[solution.faceOf()[e]] += l;
            area[solution.faceOf()[e]] += a;
            lightSum += l;
            areaSum += a;
        }
        for (int f = 0; f < light.length; f++) {
            light[f] = !(area[f] > 0) ? 0 : !(lightSum > 0) ? 1 : Math.min(1, light[f] / area[f] * areaSum / lightSum);
        }
        return light;
    }

    /** The axes along which most of the scene's surface faces. */
    PrincipalAxes axes() {
        return axes;
    }

    /**
     * The score of a view: the lit area in view, times the square of the share of the picture that lit surface fills,
     * times the square root of the number of directions that the surfaces face. One object or near surfaces that fill
     * much of the picture reduce the score, and so does a camera that looks up.
     *
     * @param columns rays across the picture, at most {@link #COLUMNS}
     * @param rows    rays down the picture, at most {@link #ROWS}
     */
    double score(Camera camera, int columns, int rows) {
        View view = new View(camera);
        double tangent = StrictMath.tan(camera.verticalHalfAngle());
        double pixel = tangent * tangent / (columns * rows);
        Hit hit = new Hit();
        for (int i = 0; i < columns * rows; i++) {
            double x = (2 * (i % columns) + 1.0) / columns - 1;
            double y = (2 * (i / columns) + 1.0) / rows - 1;
            Vec3 direction = camera.direction(x, y);
            if (visible(camera.position(), direction, hit)) {
                double axis = direction.dot(camera.forward());
                view.add(hit, pixel * axis * axis * axis);
            }
        }
        return view.score(columns * rows);
    }

    /** Collects what the rays of one view meet. */
    private final class View {
        private final Camera camera;
        private final Map<Integer, Integer> objects = new LinkedHashMap<>();
        private final double[] facing = new double[6];
        private final double[] distances = new double[COLUMNS * ROWS];
        private double area;
        private double distance;
        private int met;
        private int filled;

        View(Camera camera) {
            this.camera = camera;
        }

        /** @param pixel area, up to a factor, round the ray on a surface at distance 1 and right angles to the ray */
        void add(Hit hit, double pixel) {
            double share = lit[2 * hit.triangle + (hit.cosine > 0 ? 0 : 1)];
            area += share * pixel * hit.distance * hit.distance / Math.max(GRAZING, Math.abs(hit.cosine));
            filled += share > 0 ? 1 : 0;
            objects.merge(objectsOf.object[hit.triangle], 1, Integer::sum);
            facing[axes.nearest(normals[hit.triangle].times(hit.cosine > 0 ? 1 : -1))]++;
            distances[met++] = hit.distance;
            distance += hit.distance;
        }

        double score(int rays) {
            if (met == 0) {
                return 0;
            }
            double squares = 0;
            for (double f : facing) {
                squares += f * f;
            }
            int largest = 0;
            for (Map.Entry<Integer, Integer> object : objects.entrySet()) {
                if (object.getValue() > largest && !objectsOf.isShell(object.getKey(), camera.position())) {
                    largest = object.getValue();
                }
            }
            int near = 0;
            for (int i = 0; i < met; i++) {
                near += distances[i] < NEAR * distance / met ? 1 : 0;
            }
            double clear = 1 - (double) near / rays;
            double full = (double) filled / rays;
            return area * full * full * Math.sqrt((double) met * met / squares) * clear * clear
                    * room((double) largest / rays) * (1 - LOOKING_UP * Math.max(0, camera.forward().y()));
        }
    }

    /** Factor of a view's score if the largest object fills a share of the picture. */
    private static double room(double share) {
        if (share <= OBJECT) {
            return 1;
        }
        double beyond = Math.min(1, (share - OBJECT) / (LARGE_OBJECT - OBJECT));
        return (1 - beyond * (1 - LEFT)) * (1 - Math.max(0, share - LARGE_OBJECT));
    }

    /** The first surface along a ray. */
    static final class Hit {
        int triangle;
        /** Scene units. */
        double distance;
        /** Cosine of the angle between the front's normal and the way back; below 0 if the ray meets the back. */
        double cosine;
    }

    /**
     * Finds the first surface that a ray meets on a side that can be seen.
     *
     * @param direction unit direction
     * @param hit       receives the triangle; modified even if the result is false
     * @return whether there is a triangle
     */
    boolean visible(Vec3 from, Vec3 direction, Hit hit) {
        double passed = 0;
        for (int pass = 0; pass < PASSES; pass++) {
            if (!first(from, direction, passed, hit)) {
                return false;
            }
            if (hit.cosine > 0 || scene.surface(hit.triangle).twoSided()) {
                return true;
            }
            passed = hit.distance + STEP / scaled.scale;
        }
        return false;
    }

    /**
     * Finds the first triangle that a ray meets from either side.
     *
     * @param direction unit direction
     * @param beyond    distance from the ray's origin at which the search begins, scene units
     * @param hit       receives the triangle, if there is one
     * @return whether there is a triangle
     */
    boolean first(Vec3 from, Vec3 direction, double beyond, Hit hit) {
        Vec3 eye = scaled.unit(from);
        double skipped = Math.max(beyond * scaled.scale, eye.length() - 1);
        Vec3 p = eye.plus(direction.times(skipped));
        int t = scaled.bounds.nearest(p, direction, RadiosityBounds.ACROSS, weights);
        if (t < 0) {
            return false;
        }
        hit.triangle = t;
        hit.distance = (skipped + weights[0]) / scaled.scale;
        hit.cosine = -normals[t].dot(direction);
        return true;
    }

    /**
     * Finds lit places: middles of triangles, spread over the lit surface by area and light.
     *
     * @param count largest number of places
     * @return a point slightly off the surface and the unit normal of the lit side, 2 vectors per place
     */
    List<Vec3[]> litPlaces(int count) {
        double[] sums = new double[lit.length];
        double sum = 0;
        for (int f = 0; f < lit.length; f++) {
            sum += lit[f] * scene.area(f >> 1);
            sums[f] = sum;
        }
        List<Vec3[]> places = new ArrayList<>();
        int last = -1;
        for (int i = 0; i < count && sum > 0; i++) {
            int f = firstAbove(sums, sum * (i + 0.5) / count);
            if (f != last) {
                Vec3 normal = normals[f >> 1].times((f & 1) == 0 ? 1 : -1);
                places.add(new Vec3[] {scene.middle(f >> 1).plus(normal.times(OFF / scaled.scale)), normal});
            }
            last = f;
        }
        return places;
    }

    private static int firstAbove(double[] sums, double x) {
        int low = 0;
        int high = sums.length - 1;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (sums[middle] > x) {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        return low;
    }
}
