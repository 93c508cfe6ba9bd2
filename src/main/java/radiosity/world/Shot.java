package radiosity.world;

import java.io.DataInputStream;
import java.io.DataOutput;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import radiosity.formfactor.Shooter;
import radiosity.patch.Faces;
import radiosity.patch.PatchTree;
import radiosity.patch.RadiosityNodes;

/**
 * One shooter's light: the trees of elements of a patch, or of all patches of a block, and the unshot radiosity at
 * their corners. What goes over the wire, into the journal and into the scene file is this same record.
 *
 * @param trees at least one
 * @param flux  sum of |U| A over elements and channels, W
 */
record Shot(List<PatchTree> trees, double flux) implements Comparable<Shot> {

    /** What the smallest takes when written, and the smallest of its trees. */
    static final int LEAST_BYTES = 12;
    private static final int TREE_BYTES = 16;

    /** What some nodes have to shoot. */
    static Shot of(RadiosityNodes nodes, int[] tops, double flux) {
        return of(nodes, tops, flux, nodes::unshot);
    }

    /** What some nodes have ever shot. */
    static Shot total(RadiosityNodes nodes, int[] tops) {
        return of(nodes, tops, 0, nodes::shot);
    }

    static Shot of(RadiosityNodes nodes, int[] tops, double flux, PatchTree.Quantity quantity) {
        List<PatchTree> trees = new ArrayList<>(tops.length);
        for (int top : tops) {
            trees.add(PatchTree.of(nodes, top, quantity));
        }
        return new Shot(trees, flux);
    }

    /** Adds what is shot to what was shot before, where these nodes own it. */
    void markShot(RadiosityNodes nodes) {
        for (PatchTree tree : trees) {
            int top = nodes.find(tree.face(), tree.path());
            if (top >= 0) {
                tree.addShot(nodes, top);
            }
        }
    }

    /** @param weight one per channel, see {@link Shooter} */
    Shooter shooter(Faces faces, double[] weight) {
        return new Shooter(faces, trees, weight);
    }

    /** U A summed over the elements, one per channel, of the scene's squared size; signed. */
    double[] flux(Faces faces) {
        double[] sum = new double[faces.channels()];
        trees.forEach(tree -> tree.addFlux(faces, sum));
        return sum;
    }

    /** Most flux first; what is equal, by id. */
    @Override
    public int compareTo(Shot other) {
        PatchTree mine = trees.get(0);
        PatchTree others = other.trees.get(0);
        int order = Double.compare(other.flux, flux);
        order = order != 0 ? order : Integer.compare(mine.face(), others.face());
        return order != 0 ? order : Long.compare(mine.path(), others.path());
    }

    void write(DataOutput out) throws IOException {
        out.writeInt(trees.size());
        for (PatchTree tree : trees) {
            out.writeInt(tree.face());
            out.writeLong(tree.path());
            out.writeInt(tree.child().length);
            Wire.write(out, tree.child());
            Wire.write(out, tree.radiosity());
        }
        out.writeDouble(flux);
    }

    static Shot read(DataInputStream in, int channels) throws IOException {
        List<PatchTree> trees = new ArrayList<>();
        for (int n = Wire.count(in, TREE_BYTES); n > 0; n--) {
            int face = in.readInt();
            long path = in.readLong();
            int[] child = children(in, 3 * channels * Double.BYTES);
            trees.add(new PatchTree(face, path, child, Wire.doubles(in, 3 * channels * child.length)));
        }
        return new Shot(trees, in.readDouble());
    }

    /** A tree whose children did not follow their parents would have no end. */
    private static int[] children(DataInputStream in, int nodeBytes) throws IOException {
        int[] child = Wire.ints(in, Wire.count(in, Integer.BYTES + nodeBytes));
        for (int i = 0; i < child.length; i++) {
            if (child[i] != -1 && (child[i] <= i || child[i] > child.length - 4)) {
                throw new IOException("shot: expected children behind node " + i + ", got " + child[i]);
            }
        }
        return child;
    }
}
