package radiosity.output.raytrace;

import java.util.ArrayList;
import java.util.List;
import radiosity.formfactor.LightSources;
import radiosity.formfactor.PointSequence;
import radiosity.mesh.face.Faces;
import radiosity.output.mesh.Elements;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.visibility.RadiosityBounds;

/**
 * The light that arrives at a point, found anew: what surfaces emit by rays to them, what they reflect by rays all
 * round that find the solution at their ends (M. Reichert, A two-pass radiosity method driven by lights and viewer
 * position, 1992), and that of lights without geometry.
 */
final class FinalGather {

    /** Pieces of what emits: large surfaces are divided until there are at least so many, by area. */
    private static final int PIECES = 256;
    /** How far from its surface a ray begins or ends, of the scene's size. */
    private static final double LIFT = 1e-5;
    /** Least part of what a piece might send at best with which it is chosen, as it may be in view only in part. */
    private static final double LEAST = 1e-3;

    private final ElementRays rays;
    private final Scene scene;
    private final Faces faces;
    private final RadiosityBounds bounds;
    private final LightSources lights;
    private final boolean hasSky;
    private final List<Piece> pieces = new ArrayList<>();

    FinalGather(ElementRays rays) {
        this.rays = rays;
        scene = rays.solution().scene();
        faces = new Faces(scene);
        bounds = new RadiosityBounds(faces.occluders());
        lights = new LightSources(faces, bounds);
        hasSky = scene.lights().stream().anyMatch(light -> light.kind().isSky());
        double area = 0;
        for (int t = 0; t < scene.triangles(); t++) {
            area += scene.surface(t).emits() ? scene.area(t) : 0;
        }
        for (int t = 0; t < scene.triangles(); t++) {
            for (int side = 0; side < 2 && scene.surface(t).emits() && scene.area(t) > 0; side++) {
                if (side == 0 || scene.surface(t).twoSided()) {
                    int face = 2 * t + side;
                    divide(new Piece(face, Elements.corner(scene, face, 0), Elements.corner(scene, face, 1),
                            Elements.corner(scene, face, 2), scene.meanLook(t, scene.corner(t, 0), scene.corner(t, 1),
                                    scene.corner(t, 2)).exitance()), area / PIECES);
                }
            }
        }
    }

    private void divide(Piece piece, double most) {
        if (piece.cross().length() / 2 <= most) {
            pieces.add(piece);
            return;
        }
        Vec3 ab = piece.a.plus(piece.b).times(0.5);
        Vec3 bc = piece.b.plus(piece.c).times(0.5);
        Vec3 ca = piece.c.plus(piece.a).times(0.5);
        for (Vec3[] part : new Vec3[][] {{piece.a, ab, ca}, {ab, piece.b, bc}, {bc, ca, ab}, {ca, bc, piece.c}}) {
            divide(new Piece(piece.face, part[0], part[1], part[2], piece.exitance), most);
        }
    }

    /**
     * A part of a triangle that emits.
     *
     * @param a        its corners, counter-clockwise seen from the side that emits, scene units
     * @param exitance W/m²
     * @param cross    at right angles to it, twice as long as its area is large
     */
    private record Piece(int face, Vec3 a, Vec3 b, Vec3 c, Rgb exitance, Vec3 cross) {

        Piece(int face, Vec3 a, Vec3 b, Vec3 c, Rgb exitance) {
            this(face, a, b, c, exitance, b.minus(a).cross(c.minus(a)));
        }
    }

    /**
     * Irradiance, W/m².
     *
     * @param point scene units
     * @param n     unit normal of the side that receives
     * @param count of rays to what emits, and again to what reflects, at least 1
     * @param seed  of the choice of rays
     */
    Rgb irradiance(Vec3 point, Vec3 n, int count, long seed) {
        double first = (seed >>> 40) * 0x1p-24;
        double second = (seed >>> 16 & 0xFFFFFF) * 0x1p-24;
        Rgb sum = fromLights(point, n).plus(emitted(point, n, count, first, second));
        return sum.plus(reflected(point.plus(n.times(LIFT * faces.size())), n, count, first, second));
    }

    private Rgb fromLights(Vec3 point, Vec3 n) {
        double[] h = new double[faces.channels()];
        if (!lights.isEmpty()) {
            lights.addAllButSkies(faces.unit(point), n, h);
        }
        return rgb(h);
    }

    private static Rgb rgb(double[] h) {
        return h.length == 1 ? Rgb.grey(h[0]) : new Rgb(h[0], h[1], h[2]);
    }

    /** Rays uniform in the circle below the hemisphere (W. Nusselt, 1928): each brings the same. */
    private Rgb reflected(Vec3 from, Vec3 n, int count, double first, double second) {
        Vec3 u = n.cross(Math.abs(n.x()) < 0.6 ? new Vec3(1, 0, 0) : new Vec3(0, 1, 0)).unit();
        Vec3 v = n.cross(u);
        Rgb sum = Rgb.BLACK;
        for (int i = 1; i <= count; i++) {
            double square = (PointSequence.u(i) + first) % 1;
            double angle = 2 * Math.PI * ((PointSequence.v(i) + second) % 1);
            double r = Math.sqrt(square);
            Vec3 d = u.times(r * StrictMath.cos(angle)).plus(v.times(r * StrictMath.sin(angle)))
                    .plus(n.times(Math.sqrt(1 - square)));
            Rgb light = rays.reflected(from, d);
            sum = sum.plus(light != null ? light : hasSky ? rgb(lights.sky(d)) : Rgb.BLACK);
        }
        return sum.times(1.0 / count);
    }

    /** Rays to places on what emits, as many to each piece as it sends if nothing is in the way. */
    private Rgb emitted(Vec3 point, Vec3 n, int count, double first, double second) {
        double[] upTo = new double[pieces.size()];
        double all = 0;
        for (int i = 0; i < upTo.length; i++) {
            all += influence(pieces.get(i), point, n);
            upTo[i] = all;
        }
        Rgb sum = Rgb.BLACK;
        int i = 0;
        for (int k = 0; k < count && all > 0; k++) {
            double at = (k + first) / count * all;
            while (i < upTo.length - 1 && upTo[i] <= at) {
                i++;
            }
            double chance = (upTo[i] - (i == 0 ? 0 : upTo[i - 1])) / all;
            double r = Math.sqrt((PointSequence.u(k + 1) + second) % 1);
            double s = (PointSequence.v(k + 1) + first) % 1;
            sum = sum.plus(sample(pieces.get(i), point, n, r, s).times(1 / (chance * count)));
        }
        return sum;
    }

    /** About what a piece sends. */
    private static double influence(Piece piece, Vec3 point, Vec3 n) {
        Vec3 cross = piece.cross();
        double height = point.minus(piece.a).dot(cross);
        Vec3 middle = piece.a.plus(piece.b).plus(piece.c).times(1.0 / 3);
        Vec3 d = middle.minus(point);
        if (height <= 0 || Math.max(piece.a.minus(point).dot(n), Math.max(piece.b.minus(point).dot(n),
                piece.c.minus(point).dot(n))) <= 0) {
            return 0;
        }
        double reach = piece.a.minus(middle).dot(piece.a.minus(middle));
        double square = Math.max(d.dot(d), reach);
        return piece.exitance.max() * (height / square) * Math.max(d.dot(n), LEAST * Math.sqrt(square)) / square;
    }

    /**
     * What a place on a piece sends if all of the piece is like it.
     *
     * @param r where it is, from corner a, 0, to the opposite edge, 1
     * @param s and along that edge, from b to c
     */
    private Rgb sample(Piece piece, Vec3 point, Vec3 n, double r, double s) {
        Vec3 y = piece.a.times(1 - r).plus(piece.b.times(r * (1 - s))).plus(piece.c.times(r * s));
        Vec3 d = y.minus(point);
        double square = d.dot(d);
        double factor = d.dot(n) * -d.dot(piece.cross()) / (2 * Math.PI * square * square);
        if (!(d.dot(n) > 0 && factor > 0)) {
            return Rgb.BLACK;
        }
        Vec3 end = y.minus(d.times(LIFT * faces.size() / Math.sqrt(square)));
        if (bounds.blocked(faces.unit(point), faces.unit(end))) {
            return Rgb.BLACK;
        }
        int triangle = piece.face >> 1;
        return (scene.isMapped(triangle) ? scene.look(triangle, y).exitance() : piece.exitance).times(factor);
    }
}
