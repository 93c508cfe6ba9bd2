package radiosity.input.photometry;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.DoubleFunction;
import radiosity.scene.LuminousIntensity;

/**
 * Intensities as a file lists them; intensities of further planes follow by symmetry.
 *
 * @param horizontal angles, degrees
 * @param vertical   angles, degrees, ascending
 * @param candela    one per vertical angle for the first horizontal angle, then for the next
 */
record Web(double[] horizontal, double[] vertical, double[] candela) {

    /** Angles that differ by less than this count as equal, degrees. */
    private static final double ROUNDING = 1e-6;

    /** Type C, the same in all planes; the file has one plane. */
    LuminousIntensity axial() {
        return web(LuminousIntensity.Type.C, angle -> new double[] {0, 360});
    }

    /** Type C, symmetric about the planes C0 and C90; the file has 0 to 90 degrees. */
    LuminousIntensity quadrants() {
        return web(LuminousIntensity.Type.C, a -> new double[] {a, 180 - a, 180 + a, 360 - a});
    }

    /** Type C, symmetric about the plane C0; the file has 0 to 180 degrees. */
    LuminousIntensity halves() {
        return web(LuminousIntensity.Type.C, a -> new double[] {a, 360 - a});
    }

    /** Type C, symmetric about the plane C90; the file has 90 to 270 degrees, or 270 to 360 and 0 to 90. */
    LuminousIntensity mirroredAtNinety() {
        return web(LuminousIntensity.Type.C, a -> new double[] {a, a > 180 + ROUNDING ? 540 - a : 180 - a,
                Math.abs(a - 180) < ROUNDING ? 360 : a});
    }

    /** Type C without symmetry. */
    LuminousIntensity whole() {
        return web(LuminousIntensity.Type.C, a -> new double[] {a});
    }

    /** Type A or B, with -90 to 90 degrees of both angles; an angle that begins with 0 is mirrored. */
    LuminousIntensity turned(LuminousIntensity.Type type) {
        DoubleFunction<double[]> sides = horizontal.length == 1 ? a -> new double[] {-90, 90}
                : horizontal[0] < -ROUNDING ? a -> new double[] {a} : a -> new double[] {-a, a};
        if (vertical[0] < -ROUNDING) {
            return web(type, sides);
        }
        int n = vertical.length;
        double[] both = new double[2 * n - 1];
        double[] mirrored = new double[both.length * horizontal.length];
        for (int k = 0; k < both.length; k++) {
            int from = Math.abs(k - n + 1);
            both[k] = k < n - 1 ? -vertical[from] : vertical[from];
            for (int i = 0; i < horizontal.length; i++) {
                mirrored[i * both.length + k] = candela[i * n + from];
            }
        }
        return new Web(horizontal, both, mirrored).web(type, sides);
    }

    /** @param images maps a plane's horizontal angle to the angles of all planes with the same intensities */
    private LuminousIntensity web(LuminousIntensity.Type type, DoubleFunction<double[]> images) {
        Map<Long, Integer> planes = new TreeMap<>();
        for (int i = 0; i < horizontal.length; i++) {
            for (double image : images.apply(horizontal[i])) {
                planes.putIfAbsent(Math.round(image / ROUNDING), i);
            }
        }
        if (type == LuminousIntensity.Type.C) {
            Integer first = planes.get(0L);
            if (first == null) {
                throw new IllegalArgumentException("none in the plane C0");
            }
            planes.putIfAbsent(Math.round(360 / ROUNDING), first);
        }
        double[] angles = planes.keySet().stream().mapToDouble(a -> a * ROUNDING).toArray();
        double[] all = new double[angles.length * vertical.length];
        int at = 0;
        for (int plane : planes.values()) {
            System.arraycopy(candela, plane * vertical.length, all, at, vertical.length);
            at += vertical.length;
        }
        return new LuminousIntensity(type, angles, vertical, all);
    }
}
