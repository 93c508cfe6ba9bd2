package radiosity.edit;

import java.util.stream.IntStream;
import radiosity.scene.Affine;
import radiosity.scene.Camera;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.util.Aabb;

/** Turns mouse movements into an edit of one object. The object stays in the box around all other objects. */
public final class Drag {

    /** Motion of the object: along the floor, up and down, or about the vertical axis. */
    public enum Hand { LEVEL, UPRIGHT, TURN }

    /** Angle by which the object turns, radians per pixel. */
    private static final double TURN = 0.01;
    /** Least sine of the angle at which the floor is seen: at smaller angles the object would fly off. */
    private static final double GRAZING = 0.3;
    /** Gap left to the box around all other objects, relative to the diagonal of that box. */
    private static final double MARGIN = 1e-3;

    /** An object with at least this part of the scene's extent along two axes is no furniture. */
    private static final double LARGE = 0.8;

    private final int node;
    private final Vec3 grabbed;
    private final Vec3 about;
    private final Aabb box;
    private final Aabb others;
    /** Displacement that the mouse asks for, scene units; the object may have to stay behind. */
    private Vec3 by = Vec3.ZERO;
    private double turn;

    /** @param grabbed point of the object under the mouse, scene units */
    public Drag(Scene scene, int node, Vec3 grabbed) {
        boolean[] of = ObjectTriangles.triangles(scene, node);
        this.node = node;
        this.grabbed = grabbed;
        box = ObjectTriangles.box(scene, of, true);
        others = ObjectTriangles.box(scene, of, false);
        about = box.centre();
    }

    /** Whether an object is as large as a room, a floor or a wall: a user who drags there wants to look around. */
    public static boolean isTooLarge(Scene scene, int node) {
        Vec3 extent = ObjectTriangles.box(scene, node).extent();
        Vec3 whole = ObjectTriangles.box(scene, new boolean[scene.triangles()], false).extent();
        return IntStream.range(0, 3).filter(a -> extent.coordinate(a) >= LARGE * whole.coordinate(a)).count() > 1;
    }

    /**
     * Adds a mouse movement: along the floor, so that the grabbed point stays under the mouse as far as that is
     * possible; up and down; or about the vertical axis through the object's middle.
     *
     * @param right  pixels to the right
     * @param down   pixels downwards
     * @param height height of the picture, pixels
     */
    public void move(Hand hand, double right, double down, Camera camera, int height) {
        Vec3 sight = grabbed.plus(by).minus(camera.position());
        double pixel = 2 * Math.max(0, sight.dot(camera.forward())) * tangent(camera) / Math.max(1, height);
        if (hand == Hand.TURN) {
            turn += TURN * right;
        } else if (hand == Hand.UPRIGHT) {
            by = by.plus(new Vec3(0, -pixel * down, 0));
        } else {
            Vec3 aside = camera.forward().cross(camera.up());
            aside = new Vec3(aside.x(), 0, aside.z()).unit();
            Vec3 ahead = new Vec3(0, 1, 0).cross(aside);
            double rise = sight.y() / sight.length();
            double away = -pixel * down / Math.max(GRAZING, Math.abs(rise)) * (rise > GRAZING ? -1 : 1);
            by = by.plus(aside.times(pixel * right)).plus(ahead.times(away));
        }
    }

    private static double tangent(Camera camera) {
        return StrictMath.tan(camera.verticalHalfAngle());
    }

    /** Returns the object's displacement and turn so far, limited to the box around all other objects. */
    public Edit.Moved edit() {
        Affine turned = new Edit.Moved(node, about, turn, Vec3.ZERO).map();
        double[] m = turned.m();
        Vec3 half = box.extent().times(0.5);
        // half the extent of a box around the turned object
        Vec3 reach = new Vec3(Math.abs(m[0]) * half.x() + Math.abs(m[2]) * half.z(), half.y(),
                Math.abs(m[8]) * half.x() + Math.abs(m[10]) * half.z());
        double[] kept = new double[3];
        double margin = MARGIN * others.diagonal();
        for (int a = 0; a < 3; a++) {
            double lowest = others.low().coordinate(a) + reach.coordinate(a) - about.coordinate(a) + margin;
            double highest = others.high().coordinate(a) - reach.coordinate(a) - about.coordinate(a) - margin;
            double at = by.coordinate(a);
            // an object that begins beyond these limits, or is larger than the box, is not pushed
            kept[a] = lowest > highest ? at : Math.max(Math.min(0, lowest), Math.min(Math.max(0, highest), at));
        }
        return new Edit.Moved(node, about, turn, new Vec3(kept[0], kept[1], kept[2]));
    }
}
