package radiosity.setup;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import radiosity.mesh.Block;
import radiosity.mesh.Partitioner;
import radiosity.mesh.PatchTree;
import radiosity.mesh.Patcher;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.face.NodePath;
import radiosity.protocol.Shot;
import radiosity.util.ParallelFor;

/**
 * Clusters of patches that shoot together, each cut into blocks that may have different owners. Clusters are large, as
 * every receiving point looks at every cluster; blocks are small, so that all owners can be given equal work.
 */
public final class Clusters {

    public final List<Block> clusters;
    final List<Block> blocks = new ArrayList<>();
    /** Number of a block, by face and path of its first subtree. */
    private final Map<Shot.Place, Integer> number = new HashMap<>();
    /** 1 per cluster and one more: number of the cluster's first block; the last entry is the number of blocks. */
    private final int[] first;
    /** Subtrees of clusters that are divided among several blocks. */
    private final Set<Shot.Place> cut = new HashSet<>();

    /**
     * @param wanted approximate number of clusters
     * @param fine   approximate number of blocks
     */
    Clusters(Patcher patcher, int wanted, int fine) {
        clusters = Partitioner.blocks(patcher, wanted);
        first = new int[clusters.size() + 1];
        for (Block cluster : clusters) {
            List<Block> within = Partitioner.within(cluster, patcher, fine, blocks.size());
            within.forEach(block -> number.put(place(block, 0), block.id()));
            blocks.addAll(within);
            first[cluster.id() + 1] = blocks.size();
            cut.addAll(places(cluster));
            within.forEach(block -> places(block).forEach(cut::remove));
        }
    }

    private static Shot.Place place(Block block, int subtree) {
        return new Shot.Place(block.face()[subtree], block.path()[subtree]);
    }

    private static List<Shot.Place> places(Block block) {
        List<Shot.Place> places = new ArrayList<>();
        for (int i = 0; i < block.face().length; i++) {
            places.add(place(block, i));
        }
        return places;
    }

    /** Top nodes of some blocks by the divided subtree of a cluster to which they belong. */
    public Map<Shot.Place, List<Integer>> parts(RadiosityNodes nodes) {
        Map<Shot.Place, List<Integer>> parts = new HashMap<>();
        for (int top : nodes.tops()) {
            for (long path = nodes.path(top) >> 2; path >= NodePath.FACE && !cut.isEmpty(); path >>= 2) {
                Shot.Place whole = new Shot.Place(nodes.face(top), path);
                if (cut.contains(whole)) {
                    parts.computeIfAbsent(whole, p -> new ArrayList<>()).add(top);
                }
            }
        }
        return parts;
    }

    /**
     * @param shots one per block, in any order
     * @return one per cluster, the joined shots of its blocks, most flux first
     */
    public List<Shot> join(List<Shot> shots, ParallelFor parallel) {
        Shot[] ofBlock = new Shot[blocks.size()];
        shots.forEach(shot -> ofBlock[number.get(shot.place())] = shot);
        Shot[] joined = new Shot[clusters.size()];
        parallel.run(joined.length,
                c -> joined[c] = join(clusters.get(c), Arrays.asList(ofBlock).subList(first[c], first[c + 1])));
        List<Shot> sorted = new ArrayList<>(List.of(joined));
        Collections.sort(sorted);
        return sorted;
    }

    /** The blocks of a cluster. */
    public List<Block> blocks(int cluster) {
        return blocks.subList(first[cluster], first[cluster + 1]);
    }

    /**
     * @param parts one per block of the cluster, in the order of {@link #blocks}
     * @return the joined shots of a cluster's blocks
     */
    public Shot join(int cluster, List<Shot> parts) {
        return join(clusters.get(cluster), parts);
    }

    private static Shot join(Block cluster, List<Shot> parts) {
        Queue<PatchTree> trees = new ArrayDeque<>();
        double flux = 0;
        for (Shot part : parts) {
            trees.addAll(part.trees());
            flux += part.flux();
        }
        List<PatchTree> whole = new ArrayList<>();
        for (int i = 0; i < cluster.face().length; i++) {
            whole.add(PatchTree.joined(cluster.face()[i], cluster.path()[i], trees));
        }
        return new Shot(whole, flux);
    }
}
