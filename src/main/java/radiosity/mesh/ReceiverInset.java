package radiosity.mesh;

import radiosity.mesh.face.Faces;

/** Pulls the receiving points at corners of faces into their coplanar region, all faces at a corner alike. */
final class ReceiverInset {

    private final Faces faces;
    private final byte[] level;
    /** 3 per fan (see {@link Faces#fan}): sum of the unit vectors to the centroids of the faces that meet there. */
    private final double[] direction;
    /** 1 per fan: least height of a patch that meets there, in scene sizes. */
    private final double[] height;
    private final boolean[] border;

    ReceiverInset(Faces faces, byte[] level) {
        this.faces = faces;
        this.level = level;
        int most = 3 * faces.count();
        direction = new double[3 * most];
        height = new double[most];
        border = new boolean[most];
        for (int i = 0; i < most; i++) {
            meet(i / 3, i % 3);
        }
    }

    private void meet(int f, int k) {
        int i = faces.fan[3 * f + k];
        double[] d = new double[3];
        double length = 0;
        for (int a = 0; a < 3; a++) {
            double middle = ((double) faces.corner(f, 0, a) + faces.corner(f, 1, a) + faces.corner(f, 2, a)) / 3;
            d[a] = middle - faces.corner(f, k, a);
            length += d[a] * d[a];
        }
        for (int a = 0; a < 3; a++) {
            direction[3 * i + a] += d[a] / Math.sqrt(length);
        }
        double h = faces.height(f) / (1L << level[f]);
        height[i] = height[i] == 0 ? h : Math.min(height[i], h);
        border[i] |= faces.isBorder(f, (k + 1) % 3) || faces.isBorder(f, (k + 2) % 3);
    }

    /** 9 per face: displacement of the receiving point at each corner; 0 at corners on no border of a region. */
    float[] displacements() {
        float[] pull = new float[9 * faces.count()];
        for (int f = 0; f < faces.count(); f++) {
            for (int k = 0; k < 3; k++) {
                int i = faces.fan[3 * f + k];
                if (border[i]) {
                    put(pull, 9 * f + 3 * k, i);
                }
            }
        }
        return pull;
    }

    private void put(float[] pull, int at, int i) {
        double x = direction[3 * i];
        double y = direction[3 * i + 1];
        double z = direction[3 * i + 2];
        double length = Math.sqrt(x * x + y * y + z * z);
        if (length > 1e-6) {
            double scale = Patcher.PULL * height[i] / length;
            pull[at] = (float) (x * scale);
            pull[at + 1] = (float) (y * scale);
            pull[at + 2] = (float) (z * scale);
        }
    }
}
