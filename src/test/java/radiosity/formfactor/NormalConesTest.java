package radiosity.formfactor;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;

class NormalConesTest {

    private static final int CASES = 2000;

    private final Random random = new Random(7);

    /** Cones of 2, 4, 8 ... normals, and points within a sphere that have them: no cosine is larger than is said. */
    @Test
    void noNormalInTheConeStandsCloserThanIsSaid() {
        int culled = 0;
        for (int i = 0; i < CASES; i++) {
            int leaves = 1 << 1 + i % 4;
            float[] axis = unit();
            float[] normal = new float[3 * leaves];
            NormalCones cones = new NormalCones(2 * leaves);
            for (int n = 0; n < leaves; n++) {
                float[] one = near(axis, 0.5f * random.nextFloat());
                System.arraycopy(one, 0, normal, 3 * n, 3);
                cones.set(leaves + n, one, 0);
            }
            for (int n = leaves - 1; n > 0; n--) {
                cones.enclose(n, 2 * n, 2 * n + 1);
            }
            culled += check(cones, normal) ? 1 : 0;
        }
        assertTrue(culled > CASES / 20, "some face away as a whole, " + culled);
    }

    /** @return whether all is said to face away */
    private boolean check(NormalCones cones, float[] normal) {
        float[] to = unit();
        float d = 1 + random.nextFloat();
        float r = 0.9f * random.nextFloat();
        float sin = r / d;
        float cos = (float) Math.sqrt(1 - sin * sin);
        float said = cones.most(1, to[0] * d, to[1] * d, to[2] * d, d, sin, cos);
        for (int i = 0; i < 20; i++) {
            float[] off = unit();
            int n = 3 * random.nextInt(normal.length / 3);
            float part = r * random.nextFloat();
            double length = 0;
            double dot = 0;
            for (int a = 0; a < 3; a++) {
                double x = to[a] * d + off[a] * part;
                length += x * x;
                dot -= x * normal[n + a];
            }
            assertTrue(dot / Math.sqrt(length) <= said + 2e-3, "cosine " + dot / Math.sqrt(length) + ", said " + said);
        }
        return said <= 0;
    }

    @Test
    void oppositeNormals_areACone_ofAllDirections() {
        NormalCones cones = new NormalCones(4);
        cones.set(2, new float[] {0, 0, 1}, 0);
        cones.set(3, new float[] {0, 0, -1}, 0);
        cones.enclose(1, 2, 3);
        for (int i = 0; i < 20; i++) {
            float[] to = unit();
            assertTrue(cones.most(1, to[0], to[1], to[2], 1, 0, 1) >= Math.abs(to[2]));
        }
    }

    private float[] unit() {
        return near(new float[3], 1);
    }

    private float[] near(float[] axis, float far) {
        double[] v = new double[3];
        double length = 0;
        for (int a = 0; a < 3; a++) {
            v[a] = axis[a] + far * random.nextGaussian();
            length += v[a] * v[a];
        }
        float[] unit = new float[3];
        for (int a = 0; a < 3; a++) {
            unit[a] = (float) (v[a] / Math.sqrt(length));
        }
        return unit;
    }
}
