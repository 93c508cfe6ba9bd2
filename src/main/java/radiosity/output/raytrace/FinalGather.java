package radiosity.output.raytrace;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import radiosity.formfactor.LightSources;
import radiosity.mesh.face.Faces;
import radiosity.output.mesh.Elements;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.util.Frame;
import radiosity.util.R2;
import radiosity.visibility.RadiosityBounds;

/**
 * Gathers the light that arrives at a point anew: emitted light and light that bright surfaces reflect by rays to these
 * surfaces, other reflected light by rays in all directions, which find the solution at their ends (M. Reichert, A
 * two-pass radiosity method driven by lights and viewer position, 1992), and the light of lights without geometry.
 *
 * <p>A surface is bright if it reflects much more than the mean, such as the inside of a lampshade: too few of the rays
 * in all directions would meet emitting and bright surfaces.
 */
final class FinalGather {

    /** Emitting and bright sides are divided until no piece has more than 1 / PIECES of their area. */
    private static final int PIECES = 256;
    /**
     * Sides that reflect this many times the mean radiosity are bright; only the brightest ones, up to a number, count.
     */
    private static final double BRIGHT = 3;
    private static final int MOST_BRIGHT = 2048;
    /** Least cosine at the point in the influence of a piece, which may be in view in part if its middle is not. */
    private static final double LEAST = 1e-3;

    private final ElementRays rays;
    private final Scene scene;
    private final Faces faces;
    private final RadiosityBounds bounds;
    private final LightSources lights;
    private final boolean hasSky;
    private final List<Piece> pieces = new ArrayList<>();
    /** 1 per side of a triangle: whether rays to pieces gather the side's reflected light. */
    private final boolean[] isBright;

    FinalGather(ElementRays rays) {
        this.rays = rays;
        scene = rays.solution().scene();
        faces = new Faces(scene);
        bounds = new RadiosityBounds(faces.occluders());
        lights = new LightSources(faces, bounds);
        hasSky = scene.lights().stream().anyMatch(light -> light.kind().isSky());
        isBright = new boolean[2 * scene.triangles()];
        List<Piece> whole = bright();
        for (int face = 0; face < isBright.length; face++) {
            int t = face >> 1;
            if (scene.surface(t).emits() && ((face & 1) == 0 || scene.surface(t).twoSided())) {
                whole.add(piece(face, false, scene.meanMaterial(t, scene.corner(t, 0), scene.corner(t, 1),
                        scene.corner(t, 2)).exitance()));
            }
        }
        double area = whole.stream().mapToDouble(piece -> piece.cross.length() / 2).sum();
        whole.stream().filter(piece -> piece.cross.length() > 0).forEach(piece -> divide(piece, area / PIECES));
    }

    /** The sides of triangles that reflect much more than the mean, as one piece each. */
    private List<Piece> bright() {
        Solution solution = rays.solution();
        double[] area = new double[isBright.length];
        Rgb[] flux = new Rgb[isBright.length];
        Arrays.fill(flux, Rgb.BLACK);
        double sum = 0;
        for (int e = 0; e < solution.elements(); e++) {
            int face = solution.faceOf()[e];
            double a = Elements.cross(solution, e).length() / 2;
            area[face] += a;
            flux[face] = flux[face].plus(rays.reflected(e, 1.0 / 3, 1.0 / 3).times(a));
            sum += rays.reflected(e, 1.0 / 3, 1.0 / 3).max() * a;
        }
        double least = BRIGHT * sum / Arrays.stream(area).sum();
        List<Piece> bright = new ArrayList<>();
        IntStream.range(0, area.length).filter(f -> flux[f].max() > least * area[f])
                .boxed().sorted(Comparator.comparingDouble(f -> -flux[f].max() / area[f])).limit(MOST_BRIGHT)
                .forEach(face -> {
                    isBright[face] = true;
                    bright.add(piece(face, true, flux[face].times(1 / area[face])));
                });
        return bright;
    }

    private Piece piece(int face, boolean isReflected, Rgb radiosity) {
        return new Piece(face, isReflected, Elements.corner(scene, face, 0), Elements.corner(scene, face, 1),
                Elements.corner(scene, face, 2), radiosity);
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
            divide(new Piece(piece.face, piece.isReflected, part[0], part[1], part[2], piece.radiosity), most);
        }
    }

    /**
     * A part of an emitting or bright side of a triangle.
     *
     * @param face        2 * triangle, + 1 for its back
     * @param isReflected whether the piece stands for the reflected light of the side, or for the emitted light
     * @param a           corners a, b and c, counter-clockwise seen from the side that gives light, scene units
     * @param radiosity   mean radiosity that is reflected or emitted, W/m²
     * @param cross       vector normal to the piece, twice as long as the piece's area is large
     */
    private record Piece(int face, boolean isReflected, Vec3 a, Vec3 b, Vec3 c, Rgb radiosity, Vec3 cross) {

        Piece(int face, boolean isReflected, Vec3 a, Vec3 b, Vec3 c, Rgb radiosity) {
            this(face, isReflected, a, b, c, radiosity, b.minus(a).cross(c.minus(a)));
        }
    }

    /**
     * Irradiance of one side of a surface at a point, W/m².
     *
     * @param point scene units
     * @param n     unit normal of the side that receives
     * @param first number of the first ray; near points are to have rays with near numbers
     * @param count number of rays in all directions, and again of rays to pieces, at least 1
     */
    Rgb irradiance(Vec3 point, Vec3 n, long first, int count) {
        Vec3 above = point.plus(n.times(RadiosityBounds.LIFT * faces.size()));
        return fromLights(point, n).plus(fromBright(point, above, n, first, count))
                .plus(fromAround(above, n, first, count));
    }

    private Rgb fromLights(Vec3 point, Vec3 n) {
        double[] h = new double[faces.channels()];
        if (!lights.isEmpty()) {
            lights.addAllButSkies(faces.unit(point), n, h);
        }
        return Rgb.of(h);
    }

    /**
     * Light from rays that are uniform in the circle below the hemisphere (W. Nusselt, 1928): all rays weigh the same.
     */
    private Rgb fromAround(Vec3 from, Vec3 n, long first, int count) {
        Frame frame = Frame.of(n);
        float[] hit = new float[3];
        Rgb sum = Rgb.BLACK;
        for (int i = 1; i <= count; i++) {
            Vec3 d = frame.diffuse(R2.u(first + i), R2.v(first + i));
            int element = rays.element(from, d, hit);
            if (element >= 0 && !isBright[rays.solution().faceOf()[element]]) {
                sum = sum.plus(rays.reflected(element, hit[1], hit[2]));
            } else if (element == ElementRays.NOTHING && hasSky) {
                sum = sum.plus(Rgb.of(lights.sky(d)));
            }
        }
        return sum.times(1.0 / count);
    }

    /** Light from rays to points on pieces; each piece gets rays in proportion to its influence. */
    private Rgb fromBright(Vec3 point, Vec3 above, Vec3 n, long first, int count) {
        double[] upTo = new double[pieces.size()];
        double all = 0;
        for (int i = 0; i < upTo.length; i++) {
            all += influence(pieces.get(i), point, n);
            upTo[i] = all;
        }
        Rgb sum = Rgb.BLACK;
        int i = 0;
        double begin = R2.u(first + 0.5);
        for (int k = 0; k < count && all > 0; k++) {
            double at = (k + begin) / count * all;
            while (i < upTo.length - 1 && upTo[i] <= at) {
                i++;
            }
            double chance = (upTo[i] - (i == 0 ? 0 : upTo[i - 1])) / all;
            double r = Math.sqrt(R2.u(first + k + 1));
            double s = R2.v(first + k + 1);
            sum = sum.plus(sample(pieces.get(i), point, above, n, r, s).times(1 / (chance * count)));
        }
        return sum;
    }

    /** Estimate of the irradiance from a piece with nothing in the way, up to a constant factor. */
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
        return piece.radiosity.max() * (height / square) * Math.max(d.dot(n), LEAST * Math.sqrt(square)) / square;
    }

    /**
     * Irradiance from a piece if all of the piece is like one of its points, W/m².
     *
     * @param above the receiving point, moved off its surface
     * @param r     position of the point on the piece: 0 at corner a, 1 on the opposite edge
     * @param s     position of the point parallel to that edge: 0 towards b, 1 towards c
     */
    private Rgb sample(Piece piece, Vec3 point, Vec3 above, Vec3 n, double r, double s) {
        Vec3 y = piece.a.times(1 - r).plus(piece.b.times(r * (1 - s))).plus(piece.c.times(r * s));
        Vec3 d = y.minus(point);
        double square = d.dot(d);
        double factor = d.dot(n) * -d.dot(piece.cross()) / (2 * Math.PI * square * square);
        if (!(d.dot(n) > 0 && factor > 0)) {
            return Rgb.BLACK;
        }
        if (piece.isReflected) {
            float[] hit = new float[3];
            int element = rays.element(above, y.minus(above).unit(), hit);
            return element < 0 || rays.solution().faceOf()[element] != piece.face ? Rgb.BLACK
                    : rays.reflected(element, hit[1], hit[2]).times(factor);
        }
        Vec3 end = y.minus(d.times(RadiosityBounds.LIFT * faces.size() / Math.sqrt(square)));
        int triangle = piece.face >> 1;
        return bounds.blocked(faces.unit(point), faces.unit(end)) ? Rgb.BLACK
                : (scene.isMapped(triangle) ? scene.material(triangle, y).exitance() : piece.radiosity).times(factor);
    }
}
