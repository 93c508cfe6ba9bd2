package radiosity.mesh;

import java.util.Arrays;
import radiosity.mesh.face.NodePath;
import radiosity.util.ArraySize;
import radiosity.util.Hash;
import radiosity.util.LongIndex;

/**
 * The nodes of some patch trees in arrays: place of each node, its vertices, its parent and children. A node is an
 * index; its path is not stored, but found from its ancestors.
 */
abstract class NodeTree {

    private static final String CORNERS = "corners of the nodes of the patch trees";

    private int count;
    private int elements;
    /** 1 per node: the face on which the node lies. */
    private int[] face;
    /** 1 per node: levels below the face. */
    private byte[] level;
    /** 1 per node: its parent; of root number i, -1 - i. */
    private int[] parent;
    /** 1 per node: first of four consecutive children, or -1. */
    private int[] child;
    /** 3 per node: vertex at each corner. */
    private int[] corner;
    /** 1 per node: an element's number among the elements, in any order; an inner node has its first child's. */
    private int[] place;
    /** Roots by face and path. */
    private final LongIndex rootOf;
    /** 1 per root, in the order in which they were added: its node. */
    private int[] root;
    /** 1 per root: its path below its face, see {@link NodePath}. */
    private long[] rootPath;
    private int roots;

    /**
     * @param roots    expected number of roots
     * @param expected expected number of nodes
     */
    NodeTree(int roots, int expected) {
        rootOf = new LongIndex(roots);
        root = new int[Math.max(1, roots)];
        rootPath = new long[root.length];
        face = new int[expected];
        level = new byte[expected];
        parent = new int[expected];
        child = new int[expected];
        corner = new int[ArraySize.of(CORNERS, 3, expected)];
        place = new int[expected];
    }

    int addRoot(int f, long path) {
        int node = add(f, NodePath.level(path), -1 - roots);
        place[node] = elements++;
        rootOf.findOrAdd(name(f, path), node);
        if (roots == root.length) {
            root = Arrays.copyOf(root, 2 * roots);
            rootPath = Arrays.copyOf(rootPath, 2 * roots);
        }
        rootPath[roots] = path;
        root[roots++] = node;
        return node;
    }

    /** @return the first of four children, whose corners are not set yet */
    int addChildren(int node) {
        int first = count;
        for (int k = 0; k < 4; k++) {
            add(face[node], level[node] + 1, node);
            place[first + k] = k == 0 ? place[node] : elements++;
        }
        child[node] = first;
        return first;
    }

    private int add(int f, int depth, int under) {
        if (count == face.length) {
            makeRoom(ArraySize.room(CORNERS, count + 1L, count + Math.max(64L, count / 4), 3));
        }
        face[count] = f;
        level[count] = (byte) depth;
        parent[count] = under;
        child[count] = -1;
        return count++;
    }

    /** Makes room for about this number of further divided nodes. */
    void expect(int divided) {
        int room = ArraySize.room(CORNERS, count, count + 4L * divided, 3);
        if (room > face.length) {
            makeRoom(room);
        }
    }

    private void makeRoom(int room) {
        face = Arrays.copyOf(face, room);
        level = Arrays.copyOf(level, room);
        parent = Arrays.copyOf(parent, room);
        child = Arrays.copyOf(child, room);
        corner = Arrays.copyOf(corner, 3 * room);
        place = Arrays.copyOf(place, room);
    }

    /** Number of nodes, inner nodes and elements. */
    public int nodes() {
        return count;
    }

    public int elements() {
        return elements;
    }

    int place(int node) {
        return place[node];
    }

    public int face(int node) {
        return face[node];
    }

    int level(int node) {
        return level[node];
    }

    /** Path of a node below its face, see {@link NodePath}. */
    public long path(int node) {
        long steps = 0;
        int bits = 0;
        int at = node;
        for (; parent[at] >= 0; at = parent[at]) {
            steps |= (long) (at - child[parent[at]]) << bits;
            bits += 2;
        }
        return rootPath[-1 - parent[at]] << bits | steps;
    }

    /** The parent of a node, or -1 for a top node. */
    public int parent(int node) {
        return Math.max(-1, parent[node]);
    }

    /** First of four consecutive children, or -1. */
    public int child(int node) {
        return child[node];
    }

    /** Vertex at corner k of a node. */
    public int corner(int node, int k) {
        return corner[3 * node + k];
    }

    void setCorner(int node, int k, int vertex) {
        corner[3 * node + k] = vertex;
    }

    /** The top nodes of all blocks, in the order of the blocks. */
    public int[] tops() {
        return Arrays.copyOf(root, roots);
    }

    /** The node with this face and path, or -1. */
    public int find(int onFace, long atPath) {
        int node = rootAbove(onFace, atPath);
        int levels = NodePath.level(atPath);
        while (node >= 0 && level[node] < levels) {
            node = child[node] < 0 ? -1 : child[node] + NodePath.step(atPath, level[node] + 1);
        }
        return node;
    }

    /** The element with this face whose path begins the given one, which may be deeper, or -1. */
    public int element(int onFace, long deepPath) {
        int node = rootAbove(onFace, deepPath);
        int levels = NodePath.level(deepPath);
        while (node >= 0 && child[node] >= 0 && level[node] < levels) {
            node = child[node] + NodePath.step(deepPath, level[node] + 1);
        }
        return node < 0 || child[node] >= 0 ? -1 : node;
    }

    /** The root with this face whose path begins the given one, or -1. */
    private int rootAbove(int onFace, long atPath) {
        int up = 0;
        int node = rootOf.find(name(onFace, atPath));
        while (node < 0 && up < NodePath.level(atPath)) {
            up++;
            node = rootOf.find(name(onFace, atPath >> 2 * up));
        }
        return node;
    }

    private static long name(int onFace, long atPath) {
        return Hash.mix(Hash.mix(4, onFace), atPath);
    }
}
