package radiosity.master.balance;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import radiosity.mesh.Block;
import radiosity.mesh.Patcher;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.face.Faces;
import radiosity.partition.GhostVertices;
import radiosity.setup.InitialMesh;

/**
 * How large the blocks of the initial mesh are, and which lie side by side: a receiving point on a border gathers once
 * where one host has both sides, and on each of two hosts where it has not and elements are divided between rounds;
 * else one of them gathers, see {@link GhostVertices}.
 */
public final class Borders {

    static final int DIRECTIONS = 6;

    /** Per block: blocks beside it, and how many points it has in common with each. */
    private final int[][] beside;
    private final int[][] shared;
    /** 1 per block: receiving points, by Euler's formula for a disc. */
    private final double[] points;
    /** Per block: how much of its area looks in which of {@value #DIRECTIONS} directions. */
    private final double[][] facing;

    public Borders(InitialMesh mesh) {
        points = new double[mesh.blocks.size()];
        facing = new double[points.length][DIRECTIONS];
        Patcher coarse = mesh.patcher.coarser(mesh.blocks, mesh.blocks.size());
        RadiosityNodes nodes = new RadiosityNodes(coarse, mesh.blocks);
        Map<Long, Integer> edges = new HashMap<>();
        List<Map<Integer, Integer>> common = new ArrayList<>();
        for (Block block : mesh.blocks) {
            common.add(new TreeMap<>());
            points[block.id()]++;
            double area = IntStream.of(nodes.tops(block)).mapToDouble(nodes::area).sum();
            for (int top : nodes.tops(block)) {
                facing[block.id()][direction(mesh.faces, nodes.face(top))] += nodes.area(top) / area;
                add(mesh.patcher, coarse, nodes, block.id(), top, edges, common);
            }
        }
        if (mesh.predicts()) {
            common.forEach(Map::clear);
        }
        beside = common.stream().map(c -> c.keySet().stream().mapToInt(Integer::intValue).toArray())
                .toArray(int[][]::new);
        shared = common.stream().map(c -> c.values().stream().mapToInt(Integer::intValue).toArray())
                .toArray(int[][]::new);
    }

    /** Of the six sides of a cube that one of which the normal points most. */
    private static int direction(Faces faces, int face) {
        int axis = 0;
        for (int a = 1; a < 3; a++) {
            axis = Math.abs(faces.normal(face, a)) > Math.abs(faces.normal(face, axis)) ? a : axis;
        }
        return faces.normal(face, axis) < 0 ? axis : 3 + axis;
    }

    private void add(Patcher fine, Patcher coarse, RadiosityNodes nodes, int block, int node, Map<Long, Integer> edges,
                     List<Map<Integer, Integer>> common) {
        if (!nodes.isElement(node)) {
            for (int k = 0; k < 4; k++) {
                add(fine, coarse, nodes, block, nodes.child(node) + k, edges, common);
            }
            return;
        }
        int depth = fine.level(nodes.face(node)) - coarse.level(nodes.face(node));
        points[block] += 0.5 * (1L << 2 * depth);
        for (int k = 0; k < 3; k++) {
            long p = nodes.corner(node, k);
            long q = nodes.corner(node, (k + 1) % 3);
            Integer other = edges.putIfAbsent(Math.min(p, q) << Integer.SIZE | Math.max(p, q), block);
            border(block, other == null ? -1 : other, 1 << depth, common);
        }
    }

    /** @param other on the other side of an edge, or -1 where none is known yet */
    private void border(int block, int other, int length, List<Map<Integer, Integer>> common) {
        points[block] += other == block ? -0.5 * length : 0.5 * length;
        if (other >= 0 && other != block) {
            common.get(block).merge(other, length, Integer::sum);
            common.get(other).merge(block, length, Integer::sum);
        }
    }

    int blocks() {
        return points.length;
    }

    /** Receiving points of a block in the initial mesh, about. */
    double points(int block) {
        return points[block];
    }

    /** Shares of a block that look in each direction; 1 together. */
    double[] facing(int block) {
        return facing[block];
    }

    /** Blocks beside this one; not to be modified. */
    int[] beside(int block) {
        return beside[block];
    }

    /** Points in common with each of them in the initial mesh; not to be modified. */
    int[] shared(int block) {
        return shared[block];
    }
}
