package radiosity.mesh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;

/**
 * Cuts the patch tree into blocks of neighbouring patches, in a geometric order: blocks that are close in the order are
 * close in space (section 4.3 of the paper). The blocks depend on the scene and the patch area alone; dealing block b
 * to owner b mod n interleaves the owners geometrically.
 */
public final class Partitioner {

    private static final int LEAST_PATCHES = 16;
    private static final int MOST_PATCHES = 16_384;

    private final Patcher patcher;
    private final int blockSize;
    /** Id of the first block that is made. */
    private final int first;
    private final List<Block> blocks = new ArrayList<>();
    private int[] face = new int[16];
    private long[] path = new long[16];
    private int subtrees;
    private long patches;

    private Partitioner(Patcher patcher, int wanted, int first) {
        this.patcher = patcher;
        this.first = first;
        long size = LEAST_PATCHES;
        while (size < MOST_PATCHES && size * wanted < patcher.patches()) {
            size *= 4;
        }
        blockSize = (int) size;
    }

    /**
     * All blocks of a scene, in the order of their ids.
     *
     * @param wanted approximate number of blocks; fewer where the scene has not enough patches
     */
    public static List<Block> blocks(Patcher patcher, int wanted) {
        Partitioner partitioner = new Partitioner(patcher, wanted, 0);
        for (int f : inGeometricOrder(patcher.faces())) {
            partitioner.take(f, NodePath.FACE, patcher.level(f));
        }
        partitioner.close();
        return partitioner.blocks;
    }

    /**
     * Cuts a block into smaller blocks.
     *
     * @param wanted approximate number of blocks to which the whole scene would be cut at the same block size
     * @param first  id of the first smaller block; the others follow
     */
    public static List<Block> within(Block block, Patcher patcher, int wanted, int first) {
        Partitioner partitioner = new Partitioner(patcher, wanted, first);
        for (int i = 0; i < block.face().length; i++) {
            int f = block.face()[i];
            partitioner.take(f, block.path()[i], patcher.level(f) - NodePath.level(block.path()[i]));
        }
        partitioner.close();
        return partitioner.blocks;
    }

    /** @param depth levels from the node down to its patches */
    private void take(int f, long node, int depth) {
        if (1L << 2 * depth > blockSize) {
            for (int k = 0; k < 4; k++) {
                take(f, NodePath.child(node, k), depth - 1);
            }
            return;
        }
        if (patches + (1L << 2 * depth) > blockSize) {
            close();
        }
        if (subtrees == face.length) {
            face = Arrays.copyOf(face, 2 * subtrees);
            path = Arrays.copyOf(path, 2 * subtrees);
        }
        face[subtrees] = f;
        path[subtrees++] = node;
        patches += 1L << 2 * depth;
    }

    private void close() {
        if (subtrees > 0) {
            blocks.add(new Block(first + blocks.size(), Arrays.copyOf(face, subtrees), Arrays.copyOf(path, subtrees)));
        }
        subtrees = 0;
        patches = 0;
    }

    /** The faces by the Morton codes of their centroids: G. M. Morton, A computer oriented geodetic data base, 1966. */
    private static int[] inGeometricOrder(Faces faces) {
        long[] code = new long[faces.count()];
        Integer[] order = new Integer[faces.count()];
        for (int f = 0; f < code.length; f++) {
            order[f] = f;
            for (int a = 0; a < 3; a++) {
                double middle = ((double) faces.corner(f, 0, a) + faces.corner(f, 1, a) + faces.corner(f, 2, a)) / 3;
                code[f] |= spread((long) ((middle + 0.5) * (1 << 20))) << a;
            }
        }
        Arrays.sort(order, (f, g) -> Long.compare(code[f], code[g]));
        return Arrays.stream(order).mapToInt(Integer::intValue).toArray();
    }

    /** Moves bit i to bit 3 i, for the lowest 21 bits. */
    private static long spread(long x) {
        long s = x & 0x1FFFFF;
        s = (s | s << 32) & 0x1F00000000FFFFL;
        s = (s | s << 16) & 0x1F0000FF0000FFL;
        s = (s | s << 8) & 0x100F00F00F00F00FL;
        s = (s | s << 4) & 0x10C30C30C30C30C3L;
        return (s | s << 2) & 0x1249249249249249L;
    }
}
