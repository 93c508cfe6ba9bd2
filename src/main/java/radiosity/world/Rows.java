package radiosity.world;

import java.io.DataOutputStream;
import java.io.IOException;
import java.util.Arrays;
import radiosity.formfactor.Gathering;
import radiosity.formfactor.Shooter;

/** Takes down what one receiving point sees of which element, instead of adding it up: a row of {@link CoarseSystem}. */
final class Rows implements Gathering {

    private Shooter[] shooter = new Shooter[64];
    private int[] leaf = new int[64];
    private double[] weight = new double[3 * 64];
    private int size;
    private int closed;

    @Override
    public void add(Shooter from, int element, double a, double b, double c) {
        if (size == leaf.length) {
            shooter = Arrays.copyOf(shooter, 2 * size);
            leaf = Arrays.copyOf(leaf, 2 * size);
            weight = Arrays.copyOf(weight, 6 * size);
        }
        shooter[size] = from;
        leaf[size] = element;
        weight[3 * size] = a;
        weight[3 * size + 1] = b;
        weight[3 * size + 2] = c;
        size++;
    }

    @Override
    public void close(double scale) {
        for (int i = 3 * closed; i < 3 * size; i++) {
            weight[i] *= scale;
        }
        closed = size;
    }

    /** Number of elements, then face, path and the weights of the three corners of each. */
    void write(DataOutputStream out) throws IOException {
        out.writeInt(size);
        for (int i = 0; i < size; i++) {
            out.writeInt(shooter[i].face(leaf[i]));
            out.writeLong(shooter[i].path(leaf[i]));
            for (int k = 0; k < 3; k++) {
                out.writeFloat((float) weight[3 * i + k]);
            }
        }
    }
}
