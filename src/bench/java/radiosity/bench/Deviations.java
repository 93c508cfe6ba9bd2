package radiosity.bench;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.Vector;
import java.util.function.IntPredicate;
import radiosity.formfactor.ContourFactor;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.mesh.Block;
import radiosity.mesh.Partitioner;
import radiosity.mesh.Patcher;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.face.Faces;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.settings.FormFactors;
import radiosity.settings.ReadOptions;
import radiosity.testkit.Box;
import radiosity.testkit.Calculated;
import radiosity.visibility.RadiosityBounds;

/** Measures why some things are not done as the paper does them, for docs/PAPER.md: {@code scripts/deviations}. */
public final class Deviations {

    private static final int NODES = 100_000;
    private static final int PATCHES = 10_000;
    private static final int WARM_UP = 5;
    private static final int PARTITIONS = 8;
    private static final int BLOCKS = 12 * PARTITIONS;
    private static final int POINTS = 400;
    private static final int RAYS = 4;
    private static final int SEGMENTS = 200_000;

    private final Faces faces;

    private Deviations(Scene scene) {
        faces = new Faces(scene);
    }

    /** @param arguments LightWave scenes */
    public static void main(String[] arguments) throws IOException {
        Locale.setDefault(Locale.ROOT);
        sending();
        formFactors();
        corner();
        for (String file : arguments) {
            Scene scene = LightWaveReader.read(Path.of(file), ReadOptions.defaults(), System.err::println);
            System.out.printf("%s, %d triangles%n", file, scene.triangles());
            Deviations deviations = new Deviations(scene);
            deviations.rays();
            deviations.dealing();
        }
    }

    /*---- 1: a node is an object ----*/

    /** The paper's RadiosityNode and RadiosityTriangle (4.5.7, 4.5.8), with what is sent of them. */
    private static final class Node implements Serializable {
        private static final long serialVersionUID = 1;
        private final Vector<Node> children = new Vector<>(4);
        private final double[] shot = new double[9];
    }

    private static void sending() throws IOException {
        List<Node> nodes = new ArrayList<>();
        double[][] arrays = new double[9][NODES];
        for (int i = 0; i < NODES; i++) {
            nodes.add(new Node());
        }
        for (int i = 0; i < WARM_UP; i++) {
            serialized(nodes);
            serialized(arrays);
        }
        long begin = System.nanoTime();
        double objectBytes = serialized(nodes);
        long middle = System.nanoTime();
        double arrayBytes = serialized(arrays);
        double ratio = (middle - begin) / (double) (System.nanoTime() - middle);
        System.out.printf("1  sent as objects: %.1f times the bytes, %.0f times the time that arrays take%n",
                objectBytes / arrayBytes, ratio);
    }

    private static double serialized(Object content) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream(1 << 26);
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(content);
        }
        return bytes.size();
    }

    /*---- 2: the kernel at random points ----*/

    private static void formFactors() {
        Vec3[] floor = square(0, false);
        for (double gap : new double[] {1, 0.1, 0.01}) {
            Calculated ceiling = new Calculated(square(gap, true), List.<Vec3[]>of(floor));
            double exact = ceiling.from(ceiling.calculator(FormFactors.RAYCAST, RAYS), floor, POINTS);
            double plain = 0;
            for (int i = 0; i < POINTS; i++) {
                Vec3 p = new Vec3((i + 0.5) / POINTS, (i * 0.618034) % 1, 0);
                double d = ceiling.from(ceiling.calculator(FormFactors.PLAIN, RAYS), p, new Vec3(0, 0, 1), i)
                        - ceiling.from(ceiling.calculator(FormFactors.RAYCAST, RAYS), p, new Vec3(0, 0, 1), i);
                plain += d * d / POINTS;
            }
            System.out.printf("2  unit squares %.2f apart, %d rays: error at a point %.0f %% with the paper's kernel%n", gap,
                    RAYS, 100 * Math.sqrt(plain) / exact);
        }
    }

    private static Vec3[] square(double z, boolean down) {
        Vec3 b = new Vec3(1, 0, z);
        Vec3 d = new Vec3(0, 1, z);
        return new Vec3[] {new Vec3(0, 0, z), down ? d : b, new Vec3(1, 1, z), down ? b : d};
    }

    /*---- 3: every ray against every triangle ----*/

    private void rays() {
        float[] corners = faces.occluders();
        RadiosityBounds all = new RadiosityBounds(corners);
        List<RadiosityBounds> single = new ArrayList<>();
        for (int i = 0; i < corners.length; i += 9) {
            single.add(new RadiosityBounds(Arrays.copyOfRange(corners, i, i + 9)));
        }
        float[] segments = segments();
        IntPredicate byTree = i -> blocked(all, segments, i);
        IntPredicate byAll = i -> single.stream().anyMatch(one -> blocked(one, segments, i));
        int few = Math.max(2000, 4_000_000 / single.size());
        time(byAll, few);
        time(byTree, SEGMENTS);
        System.out.printf("3  time per ray: all triangles %.1f times the tree's%n",
                time(byAll, few) / time(byTree, SEGMENTS));
    }

    private static boolean blocked(RadiosityBounds bounds, float[] s, int i) {
        int at = 6 * (i % (s.length / 6));
        return bounds.blocked(s[at], s[at + 1], s[at + 2], s[at + 3], s[at + 4], s[at + 5]);
    }

    private static float[] segments() {
        Random random = new Random(1);
        float[] segments = new float[6 * 4096];
        for (int i = 0; i < segments.length; i++) {
            segments[i] = random.nextFloat() - 0.5f;
        }
        return segments;
    }

    private static double time(IntPredicate ray, int count) {
        long begin = System.nanoTime();
        int hits = 0;
        for (int i = 0; i < count; i++) {
            hits += ray.test(i) ? 1 : 0;
        }
        return (System.nanoTime() - begin + hits * 1e-9) / count;
    }

    /*---- 4: receiving points in corners ----*/

    private static void corner() {
        for (double inside : new double[] {0, 0.001, 0.02}) {
            double sum = 0;
            for (int side = 0; side < 6; side++) {
                Vec3[] wall = new Box(Vec3.ZERO, new Vec3(1, 1, 1)).inside(side);
                sum += ContourFactor.factor(new Vec3(inside, inside, 0), new Vec3(0, 0, 1), wall);
            }
            System.out.printf("4  corner of a cube, %.3f inside: form factors add up to %.4f%n", inside, sum);
        }
    }

    /*---- 5: single triangles dealt ----*/

    private void dealing() {
        Patcher patcher = new Patcher(faces, Patcher.areaFor(faces, PATCHES), (f, small) -> null);
        List<Block> blocks = Partitioner.blocks(patcher, BLOCKS);
        RadiosityNodes whole = new RadiosityNodes(patcher, blocks);
        List<Block> single = new ArrayList<>();
        for (int p = 0; p < whole.patches(); p++) {
            int node = whole.patch(p);
            single.add(new Block(p, new int[] {whole.face(node)}, new long[] {whole.path(node)}));
        }
        System.out.printf("5  vertices on %d hosts, of those on one: %.2f times with triangles dealt, %.2f with blocks%n",
                PARTITIONS, vertices(patcher, single) / whole.vertices(), vertices(patcher, blocks) / whole.vertices());
    }

    /** Over all partitions, dealt in turn. */
    private static double vertices(Patcher patcher, List<Block> blocks) {
        double sum = 0;
        for (int p = 0; p < PARTITIONS; p++) {
            int owner = p;
            List<Block> mine = blocks.stream().filter(block -> block.id() % PARTITIONS == owner).toList();
            sum += new RadiosityNodes(patcher, mine).vertices();
        }
        return sum;
    }
}
