package radiosity.mesh;

import java.util.Arrays;
import radiosity.mesh.face.NodePath;
import radiosity.util.ArraySize;

/**
 * Trees of nodes in arrays, where each lies and what it shares with others. A node is an index; what it needs no array
 * for is found from its parents.
 */
final class NodeTree {

    private static final String CORNERS = "corners of the nodes of the patch trees";

    private int count;
    private int elements;
    /** 1 per node. */
    private int[] face;
    /** 1 per node: levels below the face. */
    private byte[] level;
    /** 1 per node: what it is a part of; of a root, -1 less its number. */
    private int[] parent;
    /** 1 per node: first of four consecutive children, or -1. */
    private int[] child;
    /** 3 per node: vertices. */
    private int[] corner;
    /** 1 per node: an element's place among the elements, in no order; an inner node has that of its first child. */
    private int[] place;
    private final Roots roots;

    /**
     * @param roots    about how many
     * @param expected about how many nodes
     */
    NodeTree(int roots, int expected) {
        this.roots = new Roots(roots);
        face = new int[expected];
        level = new byte[expected];
        parent = new int[expected];
        child = new int[expected];
        corner = new int[ArraySize.of(CORNERS, 3, expected)];
        place = new int[expected];
    }

    int addRoot(int f, long path) {
        int node = add(f, NodePath.level(path), -1 - roots.count());
        place[node] = elements++;
        roots.add(f, path, node);
        return node;
    }

    /** @return the first of four, which have no corners yet */
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

    /** Makes room for about this number of divided nodes more. */
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

    int count() {
        return count;
    }

    int elements() {
        return elements;
    }

    int place(int node) {
        return place[node];
    }

    int face(int node) {
        return face[node];
    }

    int level(int node) {
        return level[node];
    }

    /** See {@link NodePath}. */
    long path(int node) {
        long steps = 0;
        int bits = 0;
        int at = node;
        for (; parent[at] >= 0; at = parent[at]) {
            steps |= (long) (at - child[parent[at]]) << bits;
            bits += 2;
        }
        return roots.path(-1 - parent[at]) << bits | steps;
    }

    /** What a node is a part of, or -1. */
    int parent(int node) {
        return Math.max(-1, parent[node]);
    }

    int child(int node) {
        return child[node];
    }

    int corner(int node, int k) {
        return corner[3 * node + k];
    }

    void setCorner(int node, int k, int vertex) {
        corner[3 * node + k] = vertex;
    }

    /** In the order in which they were added. */
    int[] roots() {
        return roots.all();
    }

    /** The node of this name, or -1. */
    int find(int onFace, long atPath) {
        int levels = NodePath.level(atPath);
        int up = levels;
        int node = roots.find(onFace, atPath);
        while (node < 0 && up > 0) {
            up--;
            node = roots.find(onFace, atPath >> 2 * (levels - up));
        }
        for (int l = up + 1; l <= levels && node >= 0; l++) {
            node = child[node] < 0 ? -1 : child[node] + NodePath.step(atPath, l);
        }
        return node;
    }
}
