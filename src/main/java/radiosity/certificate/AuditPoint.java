package radiosity.certificate;

import java.util.Arrays;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import radiosity.formfactor.FormFactorCalculator;
import radiosity.formfactor.GatherSink;
import radiosity.formfactor.LightSources;
import radiosity.formfactor.ShooterHierarchy;
import radiosity.mesh.InteriorTest;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.UniformRadiosity;
import radiosity.mesh.VertexBulge;
import radiosity.mesh.face.Faces;
import radiosity.util.Hash;

/** A point at which a solution is looked at, what the solution has there, and what is found anew. */
final class AuditPoint {

    /** How often the light is found anew, each time by rays of their own: their differences give their error. */
    static final int TIMES = 2;

    final int face;
    /** What it stands for, of the scene's squared size. */
    final double area;
    /** Whether nobody sees it, as it lies inside a solid. */
    final boolean isBuried;
    /** The top of a block in which it lies. */
    final long top;
    /** Sum of the squared weights of the element's corners: what is left there of errors that differ at each. */
    final double spread;
    /** 3: where it is, of the scene brought to size 1. */
    final float[] place;
    /** 9: the same of its element's corners, where they receive; which is nearest; 3: their weights. */
    private final float[] corner = new float[9];
    private final int nearest;
    private final double[] weight;
    private final boolean vertexIsBuried;
    final int number;
    private final Faces faces;

    /** One per channel: W/m², and as a part. */
    private final double[] exitance;
    private final double[] reflectance;
    /** One per channel, W/m²: irradiance that is shown; what has arrived at vertices; what is more between them. */
    private final double[] shown;
    private final double[] interpolated;
    private final double[] bulge;
    private final double[] atVertex;
    /** By how much there is more of the light of sources without geometry in that than arrives of it. */
    private final double[] fromLights;
    /** The same found anew. */
    final GatherSink.Irradiance[] anew = new GatherSink.Irradiance[TIMES];
    final GatherSink.Irradiance anewAtVertex;
    /** Sum of form factors. */
    double factors;
    /** What part of the light that leaves here arrives nowhere. */
    double lost;

    /** @param weight 3: of the element's corners */
    AuditPoint(RadiosityNodes nodes, int node, double area, double[] weight, int number, InteriorTest burial,
               VertexBulge bulges) {
        this.area = area;
        this.number = number;
        faces = nodes.faces();
        face = nodes.face(node);
        int root = node;
        while (nodes.parent(root) >= 0) {
            root = nodes.parent(root);
        }
        top = nodes.path(root);
        place = AuditPlaces.within(AuditPlaces.corners(faces, face, nodes.path(node)), weight);
        isBuried = burial.isBuried(place, 0, face);
        this.weight = weight;
        nearest = weight[0] >= weight[1] && weight[0] >= weight[2] ? 0 : weight[1] >= weight[2] ? 1 : 2;
        vertexIsBuried = nodes.isBuried(nodes.corner(node, nearest));
        for (int k = 0; k < 3; k++) {
            System.arraycopy(nodes.receivers(), 3 * nodes.corner(node, k), corner, 3 * k, 3);
        }
        spread = nodes.isPoint(node) ? 1 : Arrays.stream(weight).map(w -> w * w).sum();
        exitance = channels(c -> nodes.exitance(node, c));
        reflectance = channels(c -> nodes.reflectance(node, c));
        interpolated = channels(c -> IntStream.range(0, 3)
                .mapToDouble(k -> weight[k] * nodes.light().irradiance(node, k, c)).sum());
        shown = nodes.isPoint(node) ? interpolated : channels(c -> IntStream.range(0, 3).mapToDouble(k -> weight[k]
                * bulges.shown(nodes.vertexKey(nodes.corner(node, k)), c, nodes.light().irradiance(node, k, c))).sum());
        bulge = channels(c -> nodes.light().bulge(node, c));
        atVertex = channels(c -> nodes.light().irradiance(node, nearest, c));
        fromLights = new double[faces.channels()];
        Arrays.setAll(anew, i -> new GatherSink.Irradiance(faces.channels()));
        anewAtVertex = new GatherSink.Irradiance(faces.channels());
    }

    private double[] channels(IntToDoubleFunction value) {
        return IntStream.range(0, faces.channels()).mapToDouble(value).toArray();
    }

    /** Whether it sees nothing, and has no light: the outside of a room. */
    boolean isDark() {
        return factors == 0 && Arrays.stream(interpolated).allMatch(h -> h == 0)
                && Arrays.stream(anew[0].value).allMatch(h -> h == 0);
    }

    /*---- Finding anew ----*/

    /** Adds what a shooter sends, to the point and to its element's corner. */
    void gather(FormFactorCalculator calculator, ShooterHierarchy shooter) {
        for (int i = 0; i < TIMES; i++) {
            gather(calculator, shooter, place, 0, i, anew[i]);
        }
        if (!vertexIsBuried) {
            gather(calculator, shooter, corner, 3 * nearest, TIMES, anewAtVertex);
        }
    }

    /** Adds the form factors to a shooter whose radiosity is 1. */
    void addFactors(FormFactorCalculator calculator, ShooterHierarchy ones) {
        GatherSink.Irradiance sum = new GatherSink.Irradiance(faces.channels());
        gather(calculator, ones, place, 0, 0, sum);
        factors += sum.value[0];
    }

    private void gather(FormFactorCalculator calculator, ShooterHierarchy shooter, float[] x, int at, int time,
                        GatherSink to) {
        long key = Hash.mix(Hash.mix(5 + time, face), number);
        calculator.gather(x[at], x[at + 1], x[at + 2], faces.normal(face, 0), faces.normal(face, 1),
                faces.normal(face, 2), key, shooter, to);
    }

    /** Adds the light of sources without geometry, and the uniform light of a closed room. */
    void light(LightSources lights, UniformRadiosity ambient) {
        for (int i = 0; i <= TIMES; i++) {
            double[] to = i < TIMES ? anew[i].value : anewAtVertex.value;
            lights.add(i < TIMES ? place : corner, i < TIMES ? 0 : 3 * nearest, face, to, 0);
            for (int c = 0; c < to.length; c++) {
                to[c] += ambient.at(face, c);
            }
        }
        if (!lights.isEmpty()) {
            compare(lights);
        }
    }

    private void compare(LightSources lights) {
        double[] here = new double[faces.channels()];
        lights.add(place, 0, face, here, 0);
        for (int k = 0; k < 3; k++) {
            double[] there = new double[here.length];
            lights.add(corner, 3 * k, face, there, 0);
            for (int c = 0; c < here.length; c++) {
                fromLights[c] += weight[k] * (there[c] - here[c]);
            }
        }
    }

    /*---- What came of it, of all layers of a colour together ----*/

    /** Error of the solution's radiosity, W/m². */
    double error(int colour) {
        return sum(colour, c -> reflectance[c] * (shown[c] - anew(c)));
    }

    /** What rays leave in that, W/m²; its square is the mean square. */
    double noise(int colour) {
        return sum(colour, c -> reflectance[c] * (anew[0].value[c] - anew[1].value[c])) / TIMES;
    }

    /** The error at its element's corner; 0 where that one is not used. */
    double errorAtVertex(int colour) {
        return vertexIsBuried ? 0 : sum(colour, c -> reflectance[c] * (atVertex[c] - anewAtVertex.value[c]));
    }

    /** Irradiance that the solution reflects, less what arrives, W/m². */
    double excess(int colour) {
        return sum(colour, c -> interpolated[c] + bulge[c] - (isBuried ? 0 : anew(c)));
    }

    /** Radiosity as it was found anew, W/m². */
    double radiosity(int colour) {
        return sum(colour, c -> exitance[c] + reflectance[c] * anew(c));
    }

    /** The same at its element's corner. */
    double radiosityAtVertex(int colour) {
        return sum(colour, c -> exitance[c] + reflectance[c] * anewAtVertex.value[c]);
    }

    /** By how much more was received here than what leaves here brings elsewhere, W/m²: what escapes, and lights. */
    double unaccounted(int colour) {
        return lost * leaving(colour) + (isBuried ? 0 : sum(colour, c -> fromLights[c]));
    }

    /** What leaves the surfaces of the solution, W/m². */
    double leaving(int colour) {
        return sum(colour, c -> exitance[c] + reflectance[c] * (interpolated[c] + bulge[c]));
    }

    /** The same in one channel, without its curvature. */
    double had(int channel) {
        return exitance[channel] + reflectance[channel] * interpolated[channel];
    }

    double reflectance(int colour) {
        return isBuried ? 0 : reflectance[colour];
    }

    private double anew(int channel) {
        return (anew[0].value[channel] + anew[1].value[channel]) / TIMES;
    }

    private double sum(int colour, IntToDoubleFunction value) {
        double sum = 0;
        for (int c = colour; c < faces.channels(); c += faces.colours()) {
            sum += value.applyAsDouble(c);
        }
        return sum;
    }

    boolean reflects() {
        return Arrays.stream(reflectance).anyMatch(r -> r > 0);
    }

    boolean emits() {
        return Arrays.stream(exitance).anyMatch(e -> e > 0);
    }
}
