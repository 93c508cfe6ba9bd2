package radiosity.accuracy;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import radiosity.accuracy.CieCase.Measured;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.testkit.Box;
import radiosity.testkit.Cells;
import radiosity.testkit.RoomScenes;

/**
 * The cases of CIE 171:2006 that a radiosity program can do, with exact references.
 *
 * <p>Only one surface sends light and all that receive are black, so E = M C, with the contour sum C of {@link
 * Lambert}. Points A to F stand on the wall y = 0 and G to N on floor or ceiling, all at x = 2. In 5.7 the box hides
 * what is below the line over its nearer or farther upper edge; it is as wide as the reflector and nearer, so nothing
 * is seen past its ends.
 */
final class Cie {

    private static final Surface BLACK = RoomScenes.grey("black", 0, 0);
    private static final Vec3 UP = new Vec3(0, 0, 1);
    private static final Vec3 DOWN = new Vec3(0, 0, -1);
    private static final Vec3 DEEP = new Vec3(0, 1, 0);

    private Cie() { }

    /** All cases that have points; 5.8 has a mean instead. */
    static List<CieCase> cases() {
        return List.of(areaLamp(), reflectorAndWall(4), reflectorAndCeiling(4), reflectorAndWall(0.5),
                reflectorAndCeiling(0.5), reflectorAndWall(500), reflectorAndCeiling(500), hiddenReflector(true),
                hiddenReflector(false), sky(1), sky(4));
    }

    /** 5.3: a black room with a lamp of 1 m x 1 m, 1000 cd/m², in the middle of its ceiling. */
    static CieCase areaLamp() {
        return panel("5.3 area lamp", 1, 1000 * Math.PI);
    }

    /** 5.9: a black room under a uniform sky that shines through an opening in the roof, in per cent of E_hz. */
    static CieCase sky(double opening) {
        return panel("5.9 uniform sky, opening " + opening + " m", opening, 100);
    }

    private static CieCase panel(String name, double side, double exitance) {
        double a = 2 - side / 2;
        double b = 2 + side / 2;
        double[] planes = side == 4 ? new double[] {0, 4} : new double[] {0, a, b, 4};
        int lamp = side == 4 ? 0 : 1;
        Surface panel = RoomScenes.grey("panel", exitance, 0);
        Scene scene = new Cells(planes, planes, new double[] {0, 3}).room(name, (i, j, k) -> true,
                (i, j, k, face) -> face == 5 && i == lamp && j == lamp ? panel : BLACK);
        Vec3[] polygon = square(side, 3);
        List<Measured> points = wall(2.75, -0.5, 6, 'A', p -> exitance * Lambert.factor(p, DEEP, polygon));
        points.addAll(row(0, UP, 8, p -> exitance * Lambert.factor(p, UP, polygon)));
        return new CieCase(name, scene, points);
    }

    /** 5.6: a horizontal reflector lights a wall that begins 0.5 m above it; E/(E_hz rho) in per cent. */
    static CieCase reflectorAndWall(double side) {
        Vec3[] reflector = square(side, 0);
        Vec3[] wall = {new Vec3(0, 0, 0.5), new Vec3(0, 0, 3), new Vec3(4, 0, 3), new Vec3(4, 0, 0.5)};
        return reflector(side, "wall", wall, wall(0.75, 0.5, 5, 'B', p -> 100 * Lambert.factor(p, DEEP, reflector)));
    }

    /** The same and the ceiling; a case of its own, for the wall would hide much of the 500 m from it. */
    static CieCase reflectorAndCeiling(double side) {
        Vec3[] reflector = square(side, 0);
        Vec3[] ceiling = {new Vec3(0, 0, 3), new Vec3(0, 4, 3), new Vec3(4, 4, 3), new Vec3(4, 0, 3)};
        return reflector(side, "ceiling", ceiling, row(3, DOWN, 8, p -> 100 * Lambert.factor(p, DOWN, reflector)));
    }

    private static CieCase reflector(double side, String to, Vec3[] receiver, List<Measured> points) {
        String name = "5.6 horizontal reflector, side " + side + " m, " + to;
        Scene scene = new SceneBuilder().polygon(RoomScenes.grey("reflector", 100, 0.3), square(side, 0))
                .polygon(BLACK, receiver).scene(name);
        return new CieCase(name, scene, points);
    }

    /** Seen from above, in the middle of the room. */
    private static Vec3[] square(double side, double z) {
        double a = 2 - side / 2;
        double b = 2 + side / 2;
        return new Vec3[] {new Vec3(a, a, z), new Vec3(b, a, z), new Vec3(b, b, z), new Vec3(a, b, z)};
    }

    /**
     * 5.7: a vertical reflector at y = 4 lights wall and floor, past a black box or without it; E/(E_v rho) in per
     * cent.
     */
    static CieCase hiddenReflector(boolean box) {
        String name = "5.7 vertical reflector, " + (box ? "with" : "without") + " box";
        SceneBuilder builder = new SceneBuilder().polygon(RoomScenes.grey("reflector", 100, 0.6), reflectorAbove(0))
                .polygon(BLACK, new Vec3(0, 0, 0), new Vec3(0, 0, 3), new Vec3(4, 0, 3), new Vec3(4, 0, 0))
                .polygon(BLACK, new Vec3(0, 0, 0), new Vec3(4, 0, 0), new Vec3(4, 2.5, 0), new Vec3(0, 2.5, 0));
        if (box) {
            addOutside(builder, new Box(new Vec3(0, 2.5, 0), new Vec3(4, 2.7, 1)));
        }
        List<Measured> points = wall(2.75, -0.5, 6, 'A',
                p -> 100 * Lambert.factor(p, DEEP, reflectorAbove(box ? shadow(p) : 0)));
        points.addAll(row(0, UP, 5, p -> 100 * Lambert.factor(p, UP, reflectorAbove(box ? shadow(p) : 0))));
        return new CieCase(name, builder.scene(name), points);
    }

    private static Vec3[] reflectorAbove(double z) {
        return new Vec3[] {new Vec3(0, 4, z), new Vec3(4, 4, z), new Vec3(4, 4, 3), new Vec3(0, 4, 3)};
    }

    /** Height on the reflector below which the box hides it from a point; at most that of the reflector. */
    private static double shadow(Vec3 p) {
        double steepest = Math.max((1 - p.z()) / (2.5 - p.y()), (1 - p.z()) / (2.7 - p.y()));
        return Math.min(3, Math.max(0, p.z() + (4 - p.y()) * steepest));
    }

    private static void addOutside(SceneBuilder builder, Box box) {
        for (int side = 0; side < 6; side++) {
            Vec3[] p = box.inside(side);
            if (side != 4) {
                builder.polygon(BLACK, p[3], p[2], p[1], p[0]);
            }
        }
    }

    private static List<Measured> wall(double first, double step, int count, char letter,
            ToDoubleFunction<Vec3> exact) {
        List<Measured> points = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Vec3 p = new Vec3(2, 0, first + i * step);
            points.add(new Measured(String.valueOf((char) (letter + i)), p, DEEP, exact.applyAsDouble(p)));
        }
        return points;
    }

    private static List<Measured> row(double z, Vec3 normal, int count, ToDoubleFunction<Vec3> exact) {
        List<Measured> points = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Vec3 p = new Vec3(2, 0.25 + 0.5 * i, z);
            points.add(new Measured(String.valueOf((char) ('G' + i)), p, normal, exact.applyAsDouble(p)));
        }
        return points;
    }

    /**
     * 5.8: a cube of 4 m in which all surfaces have one reflectance, with a flush ceiling panel of 10,000 lm for the
     * point source; the mean of the indirect irradiance is rho Phi / (S (1 - rho)), S = 96 m².
     */
    static Scene cube(double reflectance) {
        double[] planes = {0, 1.5, 2.5, 4};
        Surface lamp = RoomScenes.grey("lamp", 10_000, reflectance);
        Surface wall = RoomScenes.grey("wall", 0, reflectance);
        return new Cells(planes, planes, new double[] {0, 4}).room("5.8 reflectance " + reflectance,
                (i, j, k) -> true, (i, j, k, face) -> face == 5 && i == 1 && j == 1 ? lamp : wall);
    }
}
