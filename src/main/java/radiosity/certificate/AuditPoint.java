package radiosity.certificate;

import java.util.Arrays;
import java.util.function.IntToDoubleFunction;
import java.util.function.LongFunction;
import java.util.stream.IntStream;
import radiosity.formfactor.LightSources;
import radiosity.mesh.BrightVertices;
import radiosity.mesh.InteriorTest;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.UniformRadiosity;
import radiosity.mesh.VertexBulge;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.mesh.face.Subdivision;
import radiosity.protocol.Mark;
import radiosity.protocol.GatherPoints;
import radiosity.util.Hash;

/** A point at which a solution is audited: the solution's light there, and the light gathered anew. */
final class AuditPoint {

    /**
     * Light is gathered anew a pair of times: half the sum of both is the light, half the difference estimates the
     * noise of the rays. With any other number, means and noise would need other formulas.
     */
    static final int TIMES = 2;

    final int face;
    /** Path of the element that contains the point, see {@link NodePath}. */
    final long path;
    /** Area of that element, in units of the squared scene size. */
    final double elementArea;
    /** Area that the point represents, in units of the squared scene size. */
    final double area;
    /** Whether light is gathered at a corner of the element, too, and form factors are added up. */
    final boolean isDetailed;
    /** Whether the point lies inside a solid, where no light arrives. */
    final boolean isBuried;
    /** Path of the root, in its block, of the subtree that contains the point. */
    final long top;
    /** Sum of the squared corner weights: part of the variance of independent corner errors left at the point. */
    final double spread;
    /** 3: x, y, z of the point, in coordinates of the scene scaled to size 1. */
    final float[] place;
    /** 9: receiving points of the element's corners; number of the nearest corner; 3: corner weights. */
    private final float[] corner = new float[9];
    private final int nearest;
    private final double[] weight;
    private final boolean vertexIsBuried;
    final int number;
    private final Faces faces;

    /** One per channel: exitance in W/m², and reflectance. */
    private final double[] exitance;
    private final double[] reflectance;
    /**
     * One per channel each, W/m²: irradiance that is displayed; irradiance interpolated from the corners; excess of
     * the element's mean irradiance over the mean of its corners; irradiance at the nearest corner.
     */
    private final double[] shown;
    private final double[] interpolated;
    private final double[] bulge;
    private final double[] atVertex;
    /** One per channel, W/m²: irradiance of lights without geometry, between corners minus at the point. */
    private final double[] fromLights;
    /**
     * Irradiance gathered anew, W/m²: {@link #TIMES} times at the point, and as often at the nearest corner where the
     * point is detailed.
     */
    private final double[][] anew;
    private final double[][] anewAtVertex;
    /** {@link #TIMES}: a point on a surface near by, whose error counts for that time; see {@link NearbyPoints}. */
    private final AuditPoint[] near = new AuditPoint[TIMES];
    /** One per channel, of which the first counts: sum of the form factors to all elements; 0 without details. */
    private final double[] factors;
    /** Part of the light leaving the point that arrives nowhere, from 0 to 1. */
    double lost;

    /**
     * @param area   area that the point represents, in units of the squared scene size
     * @param weight 3: barycentric weights of the element's corners at the point, kept
     * @param number number of the point, from which its rays follow
     */
    AuditPoint(RadiosityNodes nodes, int node, double area, double[] weight, int number, boolean isDetailed,
               InteriorTest burial, VertexBulge bulges) {
        this.area = area;
        this.isDetailed = isDetailed;
        this.number = number;
        faces = nodes.faces();
        face = nodes.face(node);
        path = nodes.path(node);
        elementArea = nodes.area(node);
        int root = node;
        while (nodes.parent(root) >= 0) {
            root = nodes.parent(root);
        }
        top = nodes.path(root);
        place = AuditPlaces.within(faces.corners(face, nodes.path(node)), weight);
        isBuried = burial.isBuried(place, 0, face);
        this.weight = weight;
        nearest = weight[0] >= weight[1] && weight[0] >= weight[2] ? 0 : weight[1] >= weight[2] ? 1 : 2;
        vertexIsBuried = nodes.points().isBuried(nodes.corner(node, nearest));
        for (int k = 0; k < 3; k++) {
            System.arraycopy(nodes.points().receivers(), 3 * nodes.corner(node, k), corner, 3 * k, 3);
        }
        spread = nodes.isPoint(node) ? 1 : Arrays.stream(weight).map(w -> w * w).sum();
        exitance = channels(c -> nodes.exitance(node, c));
        reflectance = channels(c -> nodes.reflectance(node, c));
        interpolated = channels(c -> IntStream.range(0, 3)
                .mapToDouble(k -> weight[k] * nodes.light().irradiance(node, k, c)).sum());
        shown = nodes.isPoint(node) ? interpolated : shown(nodes, node, bulges);
        bulge = channels(c -> nodes.light().bulge(node, c));
        atVertex = channels(c -> nodes.light().irradiance(node, nearest, c));
        fromLights = new double[faces.channels()];
        anew = new double[TIMES][faces.channels()];
        anewAtVertex = new double[TIMES][faces.channels()];
        factors = new double[faces.channels()];
    }

    /** The irradiance that the solution shows here, interpolated between what the vertices show. */
    private double[] shown(RadiosityNodes nodes, int node, VertexBulge bulges) {
        double[] sum = new double[faces.channels()];
        for (int k = 0; k < 3; k++) {
            int corner = k;
            double[] atCorner = channels(c -> nodes.light().irradiance(node, corner, c));
            bulges.show(nodes.points().key(nodes.corner(node, k)), atCorner, 0);
            for (int c = 0; c < sum.length; c++) {
                sum[c] += weight[k] * atCorner[c];
            }
        }
        return sum;
    }

    private double[] channels(IntToDoubleFunction value) {
        return IntStream.range(0, faces.channels()).mapToDouble(value).toArray();
    }

    /** Whether the point sees no front of a surface and has no light, as on the outside of a room. */
    boolean isDark() {
        return lost == 1 && Arrays.stream(interpolated).allMatch(h -> h == 0)
                && Arrays.stream(anew[0]).allMatch(h -> h == 0);
    }

    /*---- Gathering anew ----*/

    /** Powers of two by which the light that a ray may carry is raised, as the point is bright. */
    int bright(Weights weights) {
        return BrightVertices.powers(faces, face, interpolated, 0, weights);
    }

    /** Lets the error of a point near by count among the light that arrives here, for one of {@link #TIMES}. */
    void setNear(int time, AuditPoint point) {
        near[time] = point;
    }

    /** Has the light of elements gathered at the point. */
    void gather(AuditGather gather, int bright) {
        for (int i = 0; i < TIMES; i++) {
            gather(gather, bright, i);
        }
    }

    /** Has the light of elements gathered at the point, for one of {@link #TIMES}. */
    void gather(AuditGather gather, int bright, int time) {
        gather.add(place, 0, face, key(time), GatherPoints.Rays.COARSE, bright, anew[time]);
    }

    /** Has the light of elements gathered at the nearest corner of the element. */
    void gatherAtVertex(AuditGather gather, int bright) {
        for (int i = 0; i < TIMES && !vertexIsBuried; i++) {
            gather.add(corner, 3 * nearest, face, key(TIMES + i), GatherPoints.Rays.FINE, bright, anewAtVertex[i]);
        }
    }

    /** Has the form factors to elements whose radiosity is 1 added up. */
    void gatherFactors(AuditGather gather) {
        gather.add(place, 0, face, key(0), GatherPoints.Rays.FORM_FACTORS, 0, factors);
    }

    /** The number from which rays follow. */
    private long key(int time) {
        return Hash.mix(Hash.mix(5 + time, face), number);
    }

    /** Sum of the form factors to all elements; 0 where the point is not detailed. */
    double factors() {
        return factors[0];
    }

    /** Adds the light of sources without geometry, and the uniform radiosity of a closed room. */
    void light(LightSources lights, UniformRadiosity ambient, LongFunction<LightSources.SkyRays> rays) {
        double[][] here = new double[TIMES][faces.channels()];
        for (int i = 0; i < TIMES; i++) {
            lights.add(place, 0, face, here[i], 0, rays.apply(key(i)));
            begin(anew[i], here[i], ambient);
            if (isDetailed) {
                double[] there = new double[faces.channels()];
                lights.add(corner, 3 * nearest, face, there, 0, rays.apply(key(TIMES + i)));
                begin(anewAtVertex[i], there, ambient);
            }
        }
        if (!lights.isEmpty()) {
            compare(lights, here, rays);
        }
    }

    private void begin(double[] to, double[] fromLights, UniformRadiosity ambient) {
        for (int c = 0; c < to.length; c++) {
            to[c] += fromLights[c] + ambient.at(face, c);
        }
    }

    private void compare(LightSources lights, double[][] here, LongFunction<LightSources.SkyRays> rays) {
        for (int k = 0; k < 3; k++) {
            double[] there = new double[faces.channels()];
            lights.add(corner, 3 * k, face, there, 0, rays.apply(key(2 * TIMES + k)));
            for (int c = 0; c < there.length; c++) {
                fromLights[c] += weight[k] * (there[c] - mean(here, c));
            }
        }
    }

    /*---- Results, the layers of a colour added up ----*/

    /** Error of the solution's radiosity, W/m²; positive: too bright. */
    double error(int colour) {
        return sum(colour, c -> reflectance[c] * (shown[c] - (corrected(0, c) + corrected(1, c)) / 2));
    }

    /** Noise that the rays of the audit leave in {@link #error}, W/m²; the square of it estimates the variance. */
    double noise(int colour) {
        return sum(colour, c -> reflectance[c] * (corrected(0, c) - corrected(1, c)) / 2);
    }

    /** Irradiance gathered anew, minus the part that is due to errors of surfaces near by, W/m². */
    private double corrected(int time, int channel) {
        return anew[time][channel] - (near[time] == null ? 0 : near[time].excess(time, channel));
    }

    /** Error of the radiosity that the solution gives off here, as one of {@link #TIMES} found it, W/m². */
    private double excess(int time, int channel) {
        return reflectance[channel] * (interpolated[channel] + bulge[channel] - corrected(time, channel));
    }

    /** Error of the radiosity at the nearest corner of the element, W/m²; 0 where that corner is buried. */
    double errorAtVertex(int colour) {
        return vertexIsBuried ? 0 : sum(colour, c -> reflectance[c] * (atVertex[c] - mean(anewAtVertex, c)));
    }

    /** Noise that the rays of the audit leave in {@link #errorAtVertex}, W/m², as {@link #noise}. */
    double noiseAtVertex(int colour) {
        return vertexIsBuried ? 0 : sum(colour, c -> reflectance[c] * noise(anewAtVertex, c));
    }

    /**
     * The node to be divided so that the element around the point becomes smaller by some divisions, at least 1; fewer
     * where the mesh cannot be as deep.
     */
    Mark mark(int divisions) {
        double[] at = weight.clone();
        long node = path;
        for (int i = 1; i < divisions && NodePath.level(node) + 1 < NodePath.MAX_LEVEL; i++) {
            node = NodePath.child(node, Subdivision.enter(at));
        }
        return new Mark(face, node);
    }

    /** Irradiance that the solution reflects, minus the irradiance gathered anew, W/m². */
    double excess(int colour) {
        return sum(colour, c -> interpolated[c] + bulge[c] - (isBuried ? 0 : mean(anew, c)));
    }

    /** Radiosity gathered anew, W/m². */
    double radiosity(int colour) {
        return sum(colour, c -> exitance[c] + reflectance[c] * mean(anew, c));
    }

    /** Radiosity gathered anew at the nearest corner of the element, W/m². */
    double radiosityAtVertex(int colour) {
        return sum(colour, c -> exitance[c] + reflectance[c] * mean(anewAtVertex, c));
    }

    /** Light that leaves the point and escapes, plus light of sources that interpolation adds at the point, W/m². */
    double unaccounted(int colour) {
        return lost * leaving(colour) + (isBuried ? 0 : sum(colour, c -> fromLights[c]));
    }

    /** Radiosity that leaves the point in the solution, W/m². */
    double leaving(int colour) {
        return sum(colour, c -> exitance[c] + reflectance[c] * (interpolated[c] + bulge[c]));
    }

    /** Radiosity in the solution in one channel, without the element's excess over its corners, W/m². */
    double had(int channel) {
        return exitance[channel] + reflectance[channel] * interpolated[channel];
    }

    double reflectance(int colour) {
        return isBuried ? 0 : reflectance[colour];
    }

    private static double mean(double[][] anew, int channel) {
        return (anew[0][channel] + anew[1][channel]) / 2;
    }

    private static double noise(double[][] anew, int channel) {
        return (anew[0][channel] - anew[1][channel]) / 2;
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
