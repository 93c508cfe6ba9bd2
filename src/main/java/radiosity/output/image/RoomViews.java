package radiosity.output.image;

import java.util.ArrayList;
import java.util.List;
import radiosity.scene.Vec3;

/** Finds, by rays, views into rooms from just before their walls. */
final class RoomViews {

    /**
     * Number of lit places from which rooms are searched, most rooms that are found, and steps towards a room's middle.
     */
    private static final int PLACES = 12;
    private static final int ROOMS = 5;
    private static final int TURNS = 2;
    /**
     * Places nearer to each other than this share of the way to the wall, in the same direction, are in the same room.
     */
    private static final double SAME_ROOM = 0.4;
    /** Directions from a room's middle to the eye, degrees; heights above the middle, of the height of the ceiling. */
    private static final int[] COMPASS = {0, 45, 315, 90, 270, 135, 225, 180, 22, 338, 68, 292, 112, 248, 158, 202};
    private static final double[] HEIGHTS = {0.35, 0.7, 0};
    /** Share of the way from the middle of a room to its wall at which the eye stands. */
    private static final double BEFORE_WALL = 0.9;

    private RoomViews() {
    }

    /** Views as pairs of an eye and a direction of any length. */
    static List<Vec3[]> of(LitView view) {
        List<Vec3[]> views = new ArrayList<>();
        for (Vec3 middle : middles(view)) {
            views.addAll(inside(middle, view));
        }
        return views;
    }

    /** Middles of rooms, one per room: half way between lit surfaces and opposite surfaces, then between the walls. */
    private static List<Vec3> middles(LitView view) {
        List<Vec3> middles = new ArrayList<>();
        LitView.Hit hit = new LitView.Hit();
        for (Vec3[] place : view.litPlaces(PLACES)) {
            if (!view.first(place[0], place[1], 0, hit)) {
                continue;
            }
            Vec3 middle = place[0].plus(place[1].times(hit.distance / 2));
            for (int turn = 0; turn < TURNS; turn++) {
                for (Vec3 axis : List.of(view.axes().right(), view.axes().front(), view.axes().up())) {
                    double ahead = reach(view, middle, axis);
                    double behind = reach(view, middle, axis.times(-1));
                    if (Double.isFinite(ahead + behind)) {
                        middle = middle.plus(axis.times((ahead - behind) / 2));
                    }
                }
            }
            Vec3 found = middle;
            if (middles.size() < ROOMS && middles.stream().noneMatch(m -> isSame(view, m, found))) {
                middles.add(middle);
            }
        }
        return middles;
    }

    /** Whether two places are near each other, compared with the free distance from the first towards the second. */
    private static boolean isSame(LitView view, Vec3 a, Vec3 b) {
        Vec3 between = b.minus(a);
        return !(between.length() > SAME_ROOM * reach(view, a, between.unit()));
    }

    /** Distance to the first surface in a direction, scene units; infinity if there is none. */
    private static double reach(LitView view, Vec3 from, Vec3 direction) {
        LitView.Hit hit = new LitView.Hit();
        return direction.length() > 0 && view.first(from, direction, 0, hit) ? hit.distance
                : Double.POSITIVE_INFINITY;
    }

    /**
     * Views from just before the walls round a place towards the place, from several heights; none if a side is open.
     */
    private static List<Vec3[]> inside(Vec3 middle, LitView view) {
        PrincipalAxes axes = view.axes();
        double[] reach = new double[6];
        for (int a = 0; a < 6; a++) {
            double s = a % 2 == 0 ? 1 : -1;
            Vec3 axis = new Vec3(a / 2 == 0 ? s : 0, a / 2 == 1 ? s : 0, a / 2 == 2 ? s : 0);
            reach[a] = reach(view, middle, axes.at(axis));
            if (!Double.isFinite(reach[a])) {
                return List.of();
            }
        }
        List<Vec3[]> candidates = new ArrayList<>();
        for (double height : HEIGHTS) {
            for (int compass : COMPASS) {
                double x = StrictMath.sin(Math.toRadians(compass));
                double z = StrictMath.cos(Math.toRadians(compass));
                double square = Math.max(Math.abs(x), Math.abs(z));
                Vec3 back = axes.at(new Vec3(x / square * reach[x > 0 ? 0 : 1], height * reach[2],
                        z / square * reach[z > 0 ? 4 : 5]));
                double distance = Math.min(back.length(), reach(view, middle, back.unit()));
                Vec3 eye = middle.plus(back.unit().times(BEFORE_WALL * distance));
                candidates.add(new Vec3[] {eye, back.times(-1)});
            }
        }
        return candidates;
    }
}
