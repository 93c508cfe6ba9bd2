package radiosity.protocol;

import java.io.DataInputStream;
import java.io.DataOutput;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import radiosity.formfactor.ShooterHierarchy;
import radiosity.mesh.PatchTree;
import radiosity.mesh.Patcher;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.UniformRadiosity;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;

/**
 * The light of one shooter: the trees of elements of a patch, or of all patches of a cluster, and the radiosity to be
 * shot at the elements' corners. The same record goes over the network, into the journal and into the scene file.
 *
 * @param trees one per top node of the shooter, at least one
 * @param flux  sum of |U| A over elements and channels, W
 */
public record Shot(List<PatchTree> trees, double flux) implements Comparable<Shot> {

    /** Bytes of a written shot without any tree: the number of trees and the flux. */
    static final int LEAST_BYTES = 12;

    /** @param tops top nodes of the shooter's trees; the first of them names the shooter */
    public static Shot of(RadiosityNodes nodes, int[] tops, double flux, PatchTree.Quantity quantity) {
        List<PatchTree> trees = new ArrayList<>(tops.length);
        for (int top : tops) {
            trees.add(PatchTree.of(nodes, top, quantity));
        }
        return new Shot(trees, flux);
    }

    /** The name of a node: its face and its path below the face. A shooter has the name of its first tree. */
    public record Place(int face, long path) { }

    /** The name of the shooter: no two shooters of a calculation have the same. */
    public Place place() {
        return new Place(trees.get(0).face(), trees.get(0).path());
    }

    /** The same radiosity on as few elements as can represent it, none larger than a patch of {@code mesh}. */
    public Shot pruned(Patcher mesh) {
        return new Shot(trees.stream().map(tree -> tree.pruned(mesh.level(tree.face()))).toList(), flux);
    }

    /** The mean radiosities over the patches of {@code mesh}, or over elements that are larger than these. */
    public Shot mean(Patcher mesh) {
        return new Shot(trees.stream().map(tree -> tree.mean(mesh.level(tree.face()))).toList(), flux);
    }

    int channels() {
        return trees.get(0).channels();
    }

    /**
     * Adds the radiosities of this shot to the shot radiosities of the elements that are among some nodes.
     *
     * @param nodes modified: the shot radiosities
     * @param parts top nodes that lie below the top of a larger tree, by the name of that tree
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

    public ShooterHierarchy shooter(Faces faces, Weights weights, UniformRadiosity ambient) {
        return new ShooterHierarchy(faces, trees, weights, ambient);
    }

    /** Signed sum of U A over the elements, one per channel; areas are relative to the scene's squared size. */
    public double[] flux(Faces faces) {
        double[] sum = new double[faces.channels()];
        trees.forEach(tree -> tree.addFlux(faces, sum));
        return sum;
    }

    /** Estimate from above of the number of bytes that the shot takes when it is written. */
    public long bytes() {
        return trees.stream().mapToLong(tree -> TreeBytes.LEAST + (long) Double.BYTES * tree.radiosity().length).sum();
    }

    /** Larger flux first; shooters of equal flux by face, then path. */
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

    /** The same trees without their radiosities. */
    public Shot withoutRadiosities() {
        return new Shot(trees.stream().map(tree -> new PatchTree(tree.face(), tree.path(), tree.child(), new double[0]))
                .toList(), flux);
    }

    /** Whether all trees have their radiosities. */
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
