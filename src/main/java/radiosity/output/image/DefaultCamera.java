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
 * From where to look at a solution: from its scene's camera, else from where most lit surface is seen and nothing is in
 * the way.
 *
 * <p>The candidates stand around the scene, and in its rooms as rays find them, along the world's axes and those of the
 * scene. Their number and that of rays does not depend on the scene's size.
 */
public final class DefaultCamera {

    private static final double ASPECT = 4.0 / 3;
    /** Half the vertical angle of view from outside and from inside, radians. */
    private static final double OUTSIDE = Math.toRadians(20);
    private static final double INSIDE = Math.toRadians(36);
    /** How much of the picture the scene fills from outside. */
    private static final double FILL = 0.97;
    /** Directions to the eye, round the compass from the front; the first of equally good ones is taken. */
    private static final int[] COMPASS = {0, 90, 270, 180, 30, 330, 60, 300, 120, 240, 150, 210};
    private static final int[] ELEVATION = {0, 25, 50, 89};
    /** Also from below: the open side of a room that is turned over may be there. */
    private static final int[] ELEVATION_TURNED = {0, 25, 50, 89, -89};
    /** A view must be better by this to be taken instead of an earlier one. */
    private static final double BETTER = 1.03;
    /** Every candidate is looked through by a picture coarser by this, and this number of them by the whole. */
    private static final int COARSE = 3;
    private static final int PROMISING = 16;

    private DefaultCamera() {
    }

    /** The scene's own camera, or a view chosen for it. */
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

    /** From round about the box that the axes put around a scene. */
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

    /** Looks at a place from such a distance that every corner around it is in the picture. */
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
