package radiosity.output.image;

import java.util.ArrayList;
import java.util.List;
import radiosity.output.mesh.Aabb;
import radiosity.scene.Camera;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;

/** From where to look at a solution: from its scene's camera, else from where most lit surface is seen. */
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
    /** A view must be better by this to be taken instead of an earlier one. */
    private static final double BETTER = 1.03;
    /** An eye inside stands this far from the corner to the middle. */
    private static final double FROM_CORNER = 0.12;

    private DefaultCamera() {
    }

    /** The scene's own camera, or a view chosen for it. */
    public static Camera of(Solution solution) {
        return solution.scene().camera().orElseGet(() -> choose(solution));
    }

    private static Camera choose(Solution solution) {
        Aabb box = Aabb.of(solution.positions());
        LitView view = new LitView(solution);
        Camera best = null;
        double most = 0;
        for (Camera camera : candidates(box)) {
            double lit = view.litArea(camera);
            if (best == null || lit > BETTER * most) {
                best = camera;
                most = lit;
            }
        }
        return best;
    }

    private static List<Camera> candidates(Aabb box) {
        List<Camera> candidates = new ArrayList<>();
        for (int elevation : ELEVATION) {
            for (int compass : COMPASS) {
                candidates.add(outside(box, Math.toRadians(compass), Math.toRadians(elevation)));
            }
        }
        for (int corner = 0; corner < 4; corner++) {
            candidates.add(inside(box, corner));
        }
        return candidates;
    }

    /** Looks at the middle from such a distance that every corner of the box is in the picture. */
    private static Camera outside(Aabb box, double compass, double elevation) {
        Vec3 back = new Vec3(StrictMath.sin(compass) * StrictMath.cos(elevation), StrictMath.sin(elevation),
                StrictMath.cos(compass) * StrictMath.cos(elevation));
        Camera camera = looking(box.centre(), back.times(-1), OUTSIDE);
        Vec3 right = camera.forward().cross(camera.up());
        double tangent = StrictMath.tan(OUTSIDE) * FILL;
        double distance = 1e-9;
        for (int corner = 0; corner < 8; corner++) {
            Vec3 p = box.corner(corner).minus(box.centre());
            double across = Math.max(Math.abs(p.dot(right)) / ASPECT, Math.abs(p.dot(camera.up()))) / tangent;
            distance = Math.max(distance, across + p.dot(back));
        }
        return looking(box.centre().plus(back.times(distance)), back.times(-1), OUTSIDE);
    }

    /** From near one of the upper corners of the box to its middle. */
    private static Camera inside(Aabb box, int corner) {
        Vec3 p = box.corner(corner & 1 | 2 | (corner & 2) << 1);
        Vec3 eye = p.plus(box.centre().minus(p).times(2 * FROM_CORNER));
        return looking(eye, box.centre().minus(eye), INSIDE);
    }

    private static Camera looking(Vec3 eye, Vec3 towards, double halfAngle) {
        Vec3 forward = towards.length() > 0 ? towards.unit() : new Vec3(0, 0, -1);
        Vec3 level = forward.cross(new Vec3(0, 1, 0));
        Vec3 right = level.length() > 0 ? level.unit() : new Vec3(1, 0, 0);
        return new Camera(eye, forward, right.cross(forward), halfAngle, ASPECT);
    }
}
