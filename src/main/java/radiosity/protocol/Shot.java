package radiosity.protocol;

import java.io.DataInputStream;
import java.io.DataOutput;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import radiosity.formfactor.ShooterHierarchy;
import radiosity.mesh.MeanTree;
import radiosity.mesh.PatchTree;
import radiosity.mesh.Patcher;
import radiosity.mesh.PrunedTree;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.UniformRadiosity;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;

/**
 * One shooter's light: the trees of elements of a patch, or of all patches of a block, and the unshot radiosity at
 * their corners. What goes over the wire, into the journal and into the scene file is this same record.
 *
 * @param trees at least one
 * @param flux  sum of |U| A over elements and channels, W
 */
public record Shot(List<PatchTree> trees, double flux) implements Comparable<Shot> {

    /** What the smallest takes when written. */
    static final int LEAST_BYTES = 12;

    public static Shot of(RadiosityNodes nodes, int[] tops, double flux, PatchTree.Quantity quantity) {
        List<PatchTree> trees = new ArrayList<>(tops.length);
        for (int top : tops) {
            trees.add(PatchTree.of(nodes, top, quantity));
        }
        return new Shot(trees, flux);
    }

    /** Of a node, for a shot that of its first tree. */
    public record Place(int face, long path) { }

    /** Tells shooters apart. */
    public Place place() {
        return new Place(trees.get(0).face(), trees.get(0).path());
    }

    /** The same on as few elements, none larger than a patch of a mesh. */
    public Shot pruned(Patcher mesh) {
        return new Shot(trees.stream().map(tree -> PrunedTree.of(tree, mesh.level(tree.face()))).toList(), flux);
    }

    /** Its means on elements that are none smaller than a patch of a mesh. */
    public Shot mean(Patcher mesh) {
        return new Shot(trees.stream().map(tree -> MeanTree.of(tree, mesh.level(tree.face()))).toList(), flux);
    }

    int channels() {
        return trees.get(0).channels();
    }

    /**
     * Adds what is shot to what was shot before, where these nodes own it.
     *
     * @param parts tops of these nodes by the tree that they are parts of
     */
    public void markShot(RadiosityNodes nodes, Map<Place, List<Integer>> parts) {
        for (PatchTree tree : trees) {
            int top = nodes.find(tree.face(), tree.path());
            if (top >= 0) {
                tree.addShot(nodes, top);
            } else {
                parts.getOrDefault(new Place(tree.face(), tree.path()), List.of())
                        .forEach(part -> tree.addShot(nodes, part));
            }
        }
    }

    public ShooterHierarchy shooter(Faces faces, Weights weights) {
        return new ShooterHierarchy(faces, trees, weights);
    }

    public ShooterHierarchy shooter(Faces faces, Weights weights, UniformRadiosity ambient) {
        return new ShooterHierarchy(faces, trees, weights, ambient);
    }

    /** U A summed over the elements, one per channel, of the scene's squared size; signed. */
    public double[] flux(Faces faces) {
        double[] sum = new double[faces.channels()];
        trees.forEach(tree -> tree.addFlux(faces, sum));
        return sum;
    }

    /** What it takes at most when written. */
    public long bytes() {
        return trees.stream().mapToLong(tree -> TreeBytes.LEAST + (long) Double.BYTES * tree.radiosity().length).sum();
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

    void write(int channels, DataOutput out) throws IOException {
        out.writeInt(trees.size());
        for (PatchTree tree : trees) {
            TreeBytes.write(tree, channels, out);
        }
        out.writeDouble(flux);
    }

    /** Without what is shot. */
    void writeTrees(DataOutput out) throws IOException {
        out.writeInt(trees.size());
        for (PatchTree tree : trees) {
            TreeBytes.writeTree(tree, out);
        }
        out.writeDouble(flux);
    }

    /** Whether it says what is shot. */
    boolean isWhole() {
        for (PatchTree tree : trees) {
            if (tree.radiosity().length == 0) {
                return false;
            }
        }
        return true;
    }

    static Shot read(DataInputStream in, int channels) throws IOException {
        List<PatchTree> trees = new ArrayList<>();
        for (int n = Wire.count(in, TreeBytes.LEAST); n > 0; n--) {
            trees.add(TreeBytes.read(in, channels));
        }
        return new Shot(trees, in.readDouble());
    }
}
