package radiosity.partition;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import radiosity.mesh.RadiosityNodes;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.scene.Vec3;
import radiosity.util.DisjointSets;
import radiosity.visibility.RadiosityBounds;

/**
 * Finds elements on which a lamp throws a spot of light between the corners, as a bulb before a wall does, or a lamp
 * beside the middle of a long skirting board. No vertex receives the light of such a spot, but the spot follows from
 * the lamp: lamps are few, and the light of a lamp at a point is known but for what stands between. An oracle for
 * refinement: P. Hanrahan, D. Salzman, L. Aupperle, A rapid hierarchical radiosity algorithm, 1991.
 */
public final class LampSpots {

    /** Part of the way to an element's middle by which points are moved, away from neighbouring elements. */
    private static final double INSIDE = 0.03;
    /** Part of its length by which a ray to a lamp ends early: the lamp itself is no obstacle. */
    private static final double BEFORE = 1e-4;
    /** Corners that receive less than this part of the light that a lamp would send there do not see the lamp. */
    private static final double HIDDEN = 1.0 / 3;
    /** Weights of the corners at the middle of an element. */
    private static final double[] MIDDLE = {1 / 3.0, 1 / 3.0, 1 / 3.0};

    private final Faces faces;
    private final RadiosityBounds bounds;
    private final List<Lamp> lamps = new ArrayList<>();

    /**
     * Emitting faces that are connected by common points, in the scene brought to size 1.
     *
     * @param middle   centre of the faces
     * @param radius   largest distance of a corner from the centre
     * @param area     area of the faces
     * @param facing   sum of area times normal over the faces: zero where the surface is closed
     * @param exitance mean over the faces, one per channel, W/m²
     */
    private record Lamp(int[] faces, Vec3 middle, double radius, double area, Vec3 facing, double[] exitance) {

        /** The largest form factor to the lamp that a point at this distance can have. */
        double most(double distance) {
            return distance <= 0 ? 1 : Math.min(1, area / (Math.PI * distance * distance));
        }

        /**
         * Form factor from a point to the whole lamp, as to a disc of the area that the lamp shows to the point: its
         * projection where it is plane, a quarter of its area where it is closed and convex.
         */
        double factor(Vec3 x, Vec3 normal) {
            Vec3 to = middle.minus(x);
            double distance = to.length();
            double cosine = to.dot(normal) / distance;
            double shown = Math.max(0, -facing.dot(to) / distance) + (area - facing.length()) / 4;
            return cosine > 0 ? shown * cosine / (Math.PI * distance * distance + shown) : 0;
        }
    }

    /** The corners of an element, its normal and its node. */
    private record Element(RadiosityNodes nodes, int node, Vec3[] corner, Vec3 normal) {

        /** Where the element receives the light that is used at corner k. */
        Vec3 receiver(int k) {
            return nodes.isPoint(node) ? at(MIDDLE) : corner[k];
        }

        /** Irradiance of the brightest corner, W/m². */
        double brightest(int channel) {
            double brightest = 0;
            for (int k = 0; k < 3; k++) {
                brightest = Math.max(brightest, nodes.light().irradiance(node, k, channel));
            }
            return brightest;
        }

        Vec3 at(double[] weight) {
            return corner[0].times(weight[0]).plus(corner[1].times(weight[1])).plus(corner[2].times(weight[2]));
        }
    }

    /** @param bounds tree of the triangles of the faces' scene */
    public LampSpots(Faces faces, RadiosityBounds bounds) {
        this.faces = faces;
        this.bounds = bounds;
        int[] emitting = IntStream.range(0, faces.count()).filter(faces::emits).toArray();
        int points = 1 + IntStream.of(emitting).flatMap(f -> IntStream.range(3 * f, 3 * f + 3))
                .map(i -> faces.point[i]).max().orElse(-1);
        DisjointSets connected = new DisjointSets(points);
        for (int f : emitting) {
            connected.join(faces.point[3 * f], faces.point[3 * f + 1]);
            connected.join(faces.point[3 * f], faces.point[3 * f + 2]);
        }
        Map<Integer, List<Integer>> groups = new TreeMap<>();
        for (int f : emitting) {
            groups.computeIfAbsent(connected.of(faces.point[3 * f]), set -> new ArrayList<>()).add(f);
        }
        groups.values().forEach(group -> lamps.add(lamp(group.stream().mapToInt(f -> f).toArray())));
    }

    private Lamp lamp(int[] group) {
        double area = 0;
        Vec3 middle = Vec3.ZERO;
        Vec3 facing = Vec3.ZERO;
        double[] exitance = new double[faces.channels()];
        for (int f : group) {
            area += faces.area(f);
            middle = middle.plus(middle(f).times(faces.area(f)));
            facing = facing.plus(normal(f).times(faces.area(f)));
            for (int c = 0; c < exitance.length; c++) {
                exitance[c] += faces.area(f) * faces.exitance(f, c);
            }
        }
        middle = middle.times(1 / area);
        double radius = 0;
        for (int f : group) {
            for (int k = 0; k < 3; k++) {
                radius = Math.max(radius, corner(f, k).minus(middle).length());
            }
        }
        for (int c = 0; c < exitance.length; c++) {
            exitance[c] /= area;
        }
        return new Lamp(group, middle, radius, area, facing, exitance);
    }

    private Vec3 normal(int face) {
        return new Vec3(faces.normal(face, 0), faces.normal(face, 1), faces.normal(face, 2));
    }

    private Vec3 middle(int face) {
        float[] middle = faces.middle(face);
        return new Vec3(middle[0], middle[1], middle[2]);
    }

    private Vec3 corner(int face, int k) {
        return new Vec3(faces.corner(face, k, 0), faces.corner(face, k, 1), faces.corner(face, k, 2));
    }

    private Element element(RadiosityNodes nodes, int node) {
        int face = nodes.face(node);
        int[] weight = new int[9];
        NodePath.weights(nodes.path(node), weight);
        Vec3[] corner = new Vec3[3];
        for (int k = 0; k < 3; k++) {
            corner[k] = Vec3.ZERO;
            for (int j = 0; j < 3; j++) {
                corner[k] = corner[k].plus(corner(face, j).times((double) weight[3 * k + j] / NodePath.ONE));
            }
        }
        return new Element(nodes, node, corner, normal(face));
    }

    /**
     * Whether a lamp lights some point of an element so much more than interpolation between its corners would say,
     * that the radiosity errs there by more than an error.
     *
     * @param error relative to the mean radiosity, at least 0
     */
    boolean spoil(RadiosityNodes nodes, int node, Weights weights, double error) {
        if (lamps.isEmpty()) {
            return false;
        }
        Element element = element(nodes, node);
        Vec3 middle = element.at(MIDDLE);
        double radius = 0;
        for (Vec3 corner : element.corner) {
            radius = Math.max(radius, corner.minus(middle).length());
        }
        for (Lamp lamp : lamps) {
            double most = lamp.most(lamp.middle.minus(middle).length() - radius - lamp.radius);
            if (light(element, lamp, most, weights) > error && spoils(lamp, element, weights, error)) {
                return true;
            }
        }
        return false;
    }

    /** Radiosity that an element reflects of the light of a lamp, relative to the mean radiosity. */
    private double light(Element element, Lamp lamp, double factor, Weights weights) {
        int face = element.nodes.face(element.node);
        double largest = 0;
        for (int c = 0; c < lamp.exitance.length; c++) {
            double irradiance = factor * lamp.exitance[c];
            largest = Math.max(largest, irradiance * faces.importance(face, c) * weights.at(face, c));
        }
        return largest;
    }

    /** Looks at the point that is nearest to the lamp, which the lamp's own foot may hide, and half-way to corners. */
    private boolean spoils(Lamp lamp, Element element, Weights weights, double error) {
        double[] nearest = nearest(lamp.middle, element.corner);
        for (int corner = -1; corner < 3; corner++) {
            double[] at = new double[3];
            for (int k = 0; k < 3; k++) {
                double inside = (1 - INSIDE) * nearest[k] + INSIDE / 3;
                at[k] = corner < 0 ? inside : (inside + (k == corner ? 1 : 0)) / 2;
            }
            if (spoils(lamp, element, at, weights, error)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Compares the light of a lamp at a point with what interpolation would give there if nothing stood between; or
     * with all light of the brightest corner, where something hides the lamp from all corners. On the edges of shadows
     * some corner has light, and elements are divided by what their vertices receive.
     *
     * @param at weights of the corners at the point to look at; not modified
     */
    private boolean spoils(Lamp lamp, Element element, double[] at, Weights weights, double error) {
        Vec3 x = element.at(at);
        double here = lamp.factor(x, element.normal);
        if (light(element, lamp, here, weights) <= error) {
            return false;
        }
        double between = 0;
        for (int k = 0; k < 3; k++) {
            between += at[k] * lamp.factor(element.receiver(k), element.normal);
        }
        int face = element.nodes.face(element.node);
        double largest = 0;
        for (int c = 0; c < lamp.exitance.length; c++) {
            double sent = lamp.exitance[c] * between;
            double brightest = element.brightest(c);
            double missed = lamp.exitance[c] * here - (brightest < HIDDEN * sent ? brightest : sent);
            largest = Math.max(largest, missed * faces.importance(face, c) * weights.at(face, c));
        }
        return largest > error && sees(x, element.normal, lamp);
    }

    /** Whether a point sees the middle of that face of a lamp from which most light would come. */
    private boolean sees(Vec3 x, Vec3 normal, Lamp lamp) {
        Vec3 best = Vec3.ZERO;
        double most = 0;
        for (int f : lamp.faces) {
            Vec3 to = middle(f).minus(x);
            double square = to.dot(to);
            double light = Math.max(0, to.dot(normal)) * Math.max(0, -to.dot(normal(f))) * faces.area(f)
                    / (square * square);
            if (light > most) {
                most = light;
                best = to;
            }
        }
        return most > 0 && !bounds.blocked(x, x.plus(best.times(1 - BEFORE)));
    }

    /**
     * Weights of the corners at the point of a triangle that is nearest to p. C. Ericson, Real-Time Collision
     * Detection, 2005, section 5.1.5.
     */
    static double[] nearest(Vec3 p, Vec3[] triangle) {
        Vec3 ab = triangle[1].minus(triangle[0]);
        Vec3 ac = triangle[2].minus(triangle[0]);
        double abA = ab.dot(p.minus(triangle[0]));
        double acA = ac.dot(p.minus(triangle[0]));
        double abB = ab.dot(p.minus(triangle[1]));
        double acB = ac.dot(p.minus(triangle[1]));
        double abC = ab.dot(p.minus(triangle[2]));
        double acC = ac.dot(p.minus(triangle[2]));
        if (abA <= 0 && acA <= 0) {
            return new double[] {1, 0, 0};
        }
        if (abB >= 0 && acB <= abB) {
            return new double[] {0, 1, 0};
        }
        if (acC >= 0 && abC <= acC) {
            return new double[] {0, 0, 1};
        }
        double inC = abA * acB - abB * acA;
        if (inC <= 0 && abA >= 0 && abB <= 0) {
            double part = abA / (abA - abB);
            return new double[] {1 - part, part, 0};
        }
        double inB = abC * acA - abA * acC;
        if (inB <= 0 && acA >= 0 && acC <= 0) {
            double part = acA / (acA - acC);
            return new double[] {1 - part, 0, part};
        }
        double inA = abB * acC - abC * acB;
        if (inA <= 0 && acB >= abB && abC >= acC) {
            double part = (acB - abB) / (acB - abB + abC - acC);
            return new double[] {0, 1 - part, part};
        }
        double all = inA + inB + inC;
        return new double[] {inA / all, inB / all, inC / all};
    }
}
