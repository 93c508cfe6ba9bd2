package radiosity.output.image;

import radiosity.output.mesh.Aabb;
import radiosity.output.mesh.Elements;
import radiosity.scene.Camera;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.visibility.RadiosityBounds;

/** Measures how much lit surface a camera sees, by a few rays among the original triangles. */
final class LitView {

    private static final int COLUMNS = 48;
    private static final int ROWS = 36;
    /** How often a ray may pass through the back of a surface. */
    private static final int PASSES = 16;
    /** The least cosine that a surface counts with: a sliver seen along its length is not seen. */
    private static final double GRAZING = 0.1;
    private static final float STEP = 1e-5f;

    private final Scene scene;
    private final Vec3 centre;
    private final double scale;
    private final RadiosityBounds bounds;
    /** Mean luminance of each side of an original triangle, 1 where it is the scene's mean or more; 2 per triangle. */
    private final double[] lit;
    private final Vec3[] normals;

    LitView(Solution solution) {
        scene = solution.scene();
        Aabb box = Aabb.of(scene.points());
        centre = box.centre();
        scale = box.diagonal() > 0 ? 1 / box.diagonal() : 1;
        float[] corners = new float[9 * scene.triangles()];
        normals = new Vec3[scene.triangles()];
        for (int t = 0; t < scene.triangles(); t++) {
            normals[t] = scene.cross(t).unit();
            for (int k = 0; k < 3; k++) {
                Vec3 p = scene.corner(t, k).minus(centre).times(scale);
                corners[9 * t + 3 * k] = (float) p.x();
                corners[9 * t + 3 * k + 1] = (float) p.y();
                corners[9 * t + 3 * k + 2] = (float) p.z();
            }
        }
        bounds = new RadiosityBounds(corners);
        lit = lit(solution);
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
            light[f] = area[f] > 0 && lightSum > 0 ? Math.min(1, light[f] / area[f] * areaSum / lightSum) : 0;
        }
        return light;
    }

    /** Lit area in view times the share of the picture that it fills. */
    double litArea(Camera camera) {
        double area = 0;
        double filled = 0;
        for (int i = 0; i < COLUMNS * ROWS; i++) {
            double x = (2 * (i % COLUMNS) + 1.0) / COLUMNS - 1;
            double y = (2 * (i / COLUMNS) + 1.0) / ROWS - 1;
            Vec3 direction = camera.direction(x, y);
            double seen = seen(camera, direction);
            area += seen;
            filled += seen > 0 ? 1 : 0;
        }
        return area * filled;
    }

    /** The lit area that the pixel around a ray covers: solid angle times distance squared / cosine. */
    private double seen(Camera camera, Vec3 direction) {
        Vec3 eye = camera.position().minus(centre).times(scale);
        double skipped = Math.max(0, eye.length() - 1);
        Vec3 o = eye.plus(direction.times(skipped));
        float from = 0;
        float[] hit = new float[3];
        for (int pass = 0; pass < PASSES; pass++) {
            Vec3 p = o.plus(direction.times(from));
            int t = bounds.nearest((float) p.x(), (float) p.y(), (float) p.z(), (float) direction.x(),
                    (float) direction.y(), (float) direction.z(), 4, hit);
            if (t < 0) {
                return 0;
            }
            double cosine = -normals[t].dot(direction);
            if (cosine > 0 || scene.surface(t).twoSided()) {
                double distance = skipped + from + hit[0];
                double axis = direction.dot(camera.forward());
                return lit[2 * t + (cosine > 0 ? 0 : 1)] * axis * axis * axis * distance * distance
                        * StrictMath.pow(StrictMath.tan(camera.verticalHalfAngle()), 2)
                        / Math.max(GRAZING, Math.abs(cosine));
            }
            from += hit[0] + STEP;
        }
        return 0;
    }
}
