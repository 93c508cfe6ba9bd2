package radiosity.world;

import java.util.Arrays;
import java.util.stream.IntStream;
import radiosity.formfactor.FormFactorCalculator;
import radiosity.formfactor.Gathering;
import radiosity.formfactor.Shooter;
import radiosity.patch.Block;
import radiosity.patch.Faces;
import radiosity.patch.Hash;
import radiosity.patch.Path;
import radiosity.patch.RadiosityNodes;

/** A point at which a solution is looked at, what the solution has there, and what is found anew. */
final class AuditPoint {

    final int face;
    /** What it stands for, of the scene's squared size. */
    final double area;
    /** 3: weights of the face's corners; below a block's top, of the node's. */
    private final double[] weight;
    private final Faces faces;
    /** 3: where it is, of the scene brought to size 1. */
    private final float[] place = new float[3];
    private final long key;

    /** The top of a block in which it lies; of a node's corner the place and the key. */
    int block;
    long top;
    private final float[] vertex = new float[3];
    private long vertexKey;
    private boolean buried;
    /** Sum of the squared weights of the element's corners: what is left there of errors that differ at each. */
    double spread;

    /** One per channel: irradiance that the solution has, W/m². */
    final double[] interpolated;
    final double[] atVertex;
    /** The same found anew. */
    final Gathering.Irradiance anew;
    final Gathering.Irradiance anewAtVertex;
    /** Sum of form factors. */
    double factors;

    AuditPoint(Faces faces, int face, double area, double b, double c, long number) {
        this.faces = faces;
        this.face = face;
        this.area = area;
        key = Hash.mix(Hash.mix(5, face), number);
        weight = new double[] {1 - b - c, b, c};
        for (int i = 0; i < 9; i++) {
            place[i % 3] += (float) (weight[i / 3] * faces.corner(face, i / 3, i % 3));
        }
        interpolated = new double[faces.channels()];
        atVertex = new double[faces.channels()];
        anew = new Gathering.Irradiance(faces.channels());
        anewAtVertex = new Gathering.Irradiance(faces.channels());
    }

    /** Whether nobody sees it, as it lies inside a solid. */
    boolean isBuried(Burial burial) {
        return burial.isBuried(place, 0, face);
    }

    /** Whether it sees nothing, and has no light: the outside of a room. */
    boolean isDark() {
        return factors == 0 && Arrays.stream(interpolated).allMatch(h -> h == 0)
                && Arrays.stream(anew.value).allMatch(h -> h == 0);
    }

    /** Takes what the solution has, if it lies below one of a block's tops. */
    void find(Block in, RadiosityNodes nodes) {
        for (int i = 0; i < in.face().length; i++) {
            if (in.face()[i] == face && isBelow(in.path()[i])) {
                block = in.id();
                top = in.path()[i];
                take(nodes, nodes.find(face, top));
            }
        }
    }

    private boolean isBelow(long path) {
        double[] w = weight.clone();
        for (int level = 1; level <= Path.level(path); level++) {
            if (step(w) != Path.step(path, level)) {
                return false;
            }
        }
        return true;
    }

    /** @param w modified: weights of a triangle's corners, then of those of the quarter that it lies in, returned */
    private static int step(double[] w) {
        int step = w[0] > 0.5 ? 0 : w[1] > 0.5 ? 1 : w[2] > 0.5 ? 2 : 3;
        for (int k = 0; k < 3; k++) {
            w[k] = step == 3 ? 1 - 2 * w[k] : step == k ? 2 * w[k] - 1 : 2 * w[k];
        }
        return step;
    }

    private void take(RadiosityNodes nodes, int topNode) {
        double[] w = weight.clone();
        for (int level = 1; level <= Path.level(top); level++) {
            step(w);
        }
        int node = topNode;
        while (!nodes.isElement(node)) {
            node = nodes.child(node) + step(w);
        }
        int nearest = w[0] >= w[1] && w[0] >= w[2] ? 0 : w[1] >= w[2] ? 1 : 2;
        spread = nodes.isPoint(node) ? 1 : w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
        for (int c = 0; c < interpolated.length; c++) {
            for (int k = 0; k < 3; k++) {
                interpolated[c] += w[k] * nodes.light().irradiance(node, k, c);
            }
            atVertex[c] = nodes.light().irradiance(node, nearest, c);
        }
        int v = nodes.corner(node, nearest);
        buried = nodes.isBuried(v);
        vertexKey = Hash.mix(5, nodes.vertexKey(v));
        System.arraycopy(nodes.receivers(), 3 * v, vertex, 0, 3);
    }

    /** Adds what a shooter sends, to the point and to its element's corner. */
    void gather(FormFactorCalculator calculator, Shooter shooter) {
        gather(calculator, shooter, place, key, anew);
        if (!buried) {
            gather(calculator, shooter, vertex, vertexKey, anewAtVertex);
        }
    }

    /** Adds the form factors to a shooter whose radiosity is 1. */
    void addFactors(FormFactorCalculator calculator, Shooter ones) {
        Gathering.Irradiance sum = new Gathering.Irradiance(faces.channels());
        gather(calculator, ones, place, key, sum);
        factors += sum.value[0];
    }

    private void gather(FormFactorCalculator calculator, Shooter shooter, float[] x, long as, Gathering to) {
        calculator.gather(x[0], x[1], x[2], faces.normal(face, 0), faces.normal(face, 1), faces.normal(face, 2), as,
                shooter, to);
    }

    /** Adds the light of sources without geometry. */
    void light(LightSources lights) {
        lights.add(place, 0, face, anew.value, 0);
        if (!buried) {
            lights.add(vertex, 0, face, anewAtVertex.value, 0);
        }
    }

    /** Error of the solution's radiosity in a channel, W/m²; of all layers of a colour together. */
    double error(int colour) {
        return reflected(colour, interpolated, anew.value);
    }

    /** The same at its element's corner; 0 where that one is not used. */
    double errorAtVertex(int colour) {
        return buried ? 0 : reflected(colour, atVertex, anewAtVertex.value);
    }

    private double reflected(int colour, double[] found, double[] truth) {
        double sum = 0;
        for (int c = colour; c < found.length; c += faces.colours()) {
            sum += faces.reflectance(face, c) * (found[c] - truth[c]);
        }
        return sum;
    }

    /** Radiosity as it was found anew, W/m². */
    double radiosity(int colour) {
        double sum = 0;
        for (int c = colour; c < interpolated.length; c += faces.colours()) {
            sum += faces.exitance(face, c) + faces.reflectance(face, c) * anew.value[c];
        }
        return sum;
    }

    boolean reflects() {
        return channels().anyMatch(c -> faces.reflectance(face, c) > 0);
    }

    boolean emits() {
        return channels().anyMatch(c -> faces.exitance(face, c) > 0);
    }

    private IntStream channels() {
        return IntStream.range(0, faces.channels());
    }
}
