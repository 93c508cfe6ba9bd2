package radiosity.input.photometry;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.DoubleFunction;
import radiosity.scene.LuminousIntensity;

/**
 * Intensities as a file lists them, of which the rest follows by symmetry.
 *
 * @param horizontal angles, degrees
 * @param vertical   angles, degrees, ascending
 * @param candela    one per vertical angle, horizontal angle by horizontal angle
 */
record Web(double[] horizontal, double[] vertical, double[] candela) {

    /** Angles that differ by less are one, degrees. */
    private static final double ROUNDING = 1e-6;

    /** One plane, which is turned around. */
    LuminousIntensity axial() {
        return web(LuminousIntensity.Type.C, angle -> new double[] {0, 360});
    }

    /** 0 to 90 degrees of four quadrants. */
    LuminousIntensity quadrants() {
        return web(LuminousIntensity.Type.C, a -> new double[] {a, 180 - a, 180 + a, 360 - a});
    }

    /** 0 to 180 degrees of two halves. */
    LuminousIntensity halves() {
        return web(LuminousIntensity.Type.C, a -> new double[] {a, 360 - a});
    }

    /** 90 to 270 degrees, or 270 to 360 and 0 to 90: of two halves, too. */
    LuminousIntensity mirroredAtNinety() {
        return web(LuminousIntensity.Type.C, a -> new double[] {a, a > 180 + ROUNDING ? 540 - a : 180 - a,
                Math.abs(a - 180) < ROUNDING ? 360 : a});
    }

    /** All around. */
    LuminousIntensity whole() {
        return web(LuminousIntensity.Type.C, a -> new double[] {a});
    }

    /** -90 to 90 degrees of both angles; what begins with 0 is the same on the other side. */
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

    /** @param images at which angles there is a plane like one of the file */
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
