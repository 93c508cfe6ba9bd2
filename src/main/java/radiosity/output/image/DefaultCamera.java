package radiosity.output.image;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import radiosity.scene.Camera;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.util.Aabb;

/**
 * Chooses from where to look at a solution: the camera of its scene or, if the scene has none, a view in which much lit
 * surface is seen and nothing is in the way.
 *
 * <p>The candidates stand around the scene, and in its rooms as rays find them, along the axes of the world and the
 * principal axes of the scene. The number of candidates and of rays does not depend on the scene's size.
 */
public final class DefaultCamera {

    private static final double ASPECT = 4.0 / 3;
    /** Half the vertical angle of view from outside and from inside, radians. */
    private static final double OUTSIDE = Math.toRadians(20);
    private static final double INSIDE = Math.toRadians(36);
    /** Share of the picture's width or height that the scene fills when seen from outside. */
    private static final double FILL = 0.97;
    /**
     * Directions to the eye round the up axis, degrees from the front; of equally good views the first one is chosen.
     */
    private static final int[] COMPASS = {0, 90, 270, 180, 30, 330, 60, 300, 120, 240, 150, 210};
    /** Heights of the eye above the horizon, degrees. */
    private static final int[] ELEVATION = {0, 25, 50, 89};
    /** Heights of the eye in the scene's own axes: also from below, where a room that is turned over may be open. */
    private static final int[] ELEVATION_TURNED = {0, 25, 50, 89, -89};
    /** Factor by which the score of a view must exceed that of the best earlier view. */
    private static final double BETTER = 1.03;
    /**
     * All candidates are scored with pictures coarser by this factor, this number of the best ones with whole pictures.
     */
    private static final int COARSE = 3;
    private static final int PROMISING = 16;

    private DefaultCamera() {
    }

    /** The camera of the solution's scene or, if the scene has none, a view chosen for the solution. */
    public static Camera of(Solution solution) {
        return solution.scene().camera().orElseGet(() -> choose(solution));
    }

    private static Camera choose(Solution solution) {
        LitView view = new LitView(solution);
        List<Camera> candidates = candidates(solution.positions(), view);
        double[] coarse = new double[candidates.size()];
        for (int i = 0; i < coarse.length; i++) {
            coarse[i] = view.score(candidates.get(i), LitView.COLUMNS / COARSE, LitView.ROWS / COARSE);
        }
        int[] promising = IntStream.range(0, coarse.length).boxed()
                .sorted(Comparator.comparingDouble(i -> -coarse[i])).limit(PROMISING)
                .mapToInt(i -> i).sorted().toArray();
        Camera best = candidates.get(0);
        double most = 0;
        for (int i : promising) {
            double score = view.score(candidates.get(i), LitView.COLUMNS, LitView.ROWS);
            if (score > BETTER * most) {
                best = candidates.get(i);
                most = score;
            }
        }
        return best;
    }

    private static List<Camera> candidates(double[] positions, LitView view) {
        List<Camera> candidates = new ArrayList<>(outside(positions, PrincipalAxes.WORLD, ELEVATION));
        if (!view.axes().equals(PrincipalAxes.WORLD)) {
            candidates.addAll(outside(positions, view.axes(), ELEVATION_TURNED));
        }
        for (Vec3[] look : RoomViews.of(view)) {
            candidates.add(looking(look[0], look[1], INSIDE));
        }
        return candidates;
    }

    /** Cameras round the box along given axes that encloses the scene. */
    private static List<Camera> outside(double[] positions, PrincipalAxes axes, int[] elevations) {
        Aabb box = axes.box(positions);
        Vec3 centre = axes.at(box.centre());
        List<Vec3> corners = IntStream.range(0, 8).mapToObj(i -> axes.at(box.corner(i)).minus(centre)).toList();
        List<Camera> candidates = new ArrayList<>();
        for (int elevation : elevations) {
            for (int compass : COMPASS) {
                double c = Math.toRadians(compass);
                double e = Math.toRadians(elevation);
                candidates.add(outside(centre, corners, axes.at(new Vec3(StrictMath.sin(c) * StrictMath.cos(e),
                        StrictMath.sin(e), StrictMath.cos(c) * StrictMath.cos(e)))));
            }
        }
        return candidates;
    }

    /**
     * A camera in direction {@code back} from a centre, so far away that all corners, relative to the centre, are seen.
     */
    private static Camera outside(Vec3 centre, List<Vec3> corners, Vec3 back) {
        Camera camera = looking(centre, back.times(-1), OUTSIDE);
        Vec3 right = camera.forward().cross(camera.up());
        double tangent = StrictMath.tan(OUTSIDE) * FILL;
        double distance = 1e-9;
        for (Vec3 p : corners) {
            double across = Math.max(Math.abs(p.dot(right)) / ASPECT, Math.abs(p.dot(camera.up()))) / tangent;
            distance = Math.max(distance, across + p.dot(back));
        }
        return looking(centre.plus(back.times(distance)), back.times(-1), OUTSIDE);
    }

    private static Camera looking(Vec3 eye, Vec3 towards, double halfAngle) {
        Vec3 forward = towards.length() > 0 ? towards.unit() : new Vec3(0, 0, -1);
        Vec3 level = forward.cross(new Vec3(0, 1, 0));
        Vec3 right = level.length() > 0 ? level.unit() : new Vec3(1, 0, 0);
        return new Camera(eye, forward, right.cross(forward), halfAngle, ASPECT);
    }
}
