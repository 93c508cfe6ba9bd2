package radiosity.mesh.face;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.IntToDoubleFunction;
import radiosity.scene.Raster;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/** The {@link FaceMap} of one quantity, exitance or reflectance, for every face on which the quantity varies. */
final class FaceMaps {

    /** 1 per face, null where the quantity is constant; the whole array null where it is constant on all faces. */
    private final FaceMap[] maps;

    /**
     * @param kind       the image of the quantity
     * @param everywhere the quantity where a surface has no image
     * @param coloured   whether the scene's vertex colours are factors of the quantity
     */
    FaceMaps(Faces faces, Function<Surface.Maps, Optional<Raster>> kind, Function<Surface, Rgb> everywhere,
             boolean coloured) {
        Scene scene = faces.scene();
        boolean none = (!coloured || scene.vertexColours().length == 0)
                && scene.surfaces().stream().allMatch(surface -> kind.apply(surface.maps()).isEmpty());
        maps = none ? null : new FaceMap[faces.count()];
        for (int f = 0; !none && f < maps.length; f++) {
            int triangle = faces.triangle(f);
            Surface surface = scene.surface(triangle);
            Optional<Raster> raster = scene.hasImages(triangle) ? kind.apply(surface.maps()) : Optional.empty();
            boolean varied = coloured && scene.isColoured(triangle);
            if (raster.isPresent() || varied) {
                float[] uv = scene.textureCoordinates();
                int first = 6 * triangle;
                double[][] colours = new double[3][];
                for (int c = 0; c < 3; c++) {
                    int channel = c;
                    colours[c] = varied ? atCorners(faces, f, j -> scene.vertexColour(triangle, j).channel(channel))
                            : new double[] {1, 1, 1};
                }
                maps[f] = new FaceMap(new FaceMap.Look(raster, everywhere.apply(surface),
                        raster.isEmpty() ? new double[3] : atCorners(faces, f, j -> uv[first + 2 * j]),
                        raster.isEmpty() ? new double[3] : atCorners(faces, f, j -> uv[first + 2 * j + 1]), colours,
                        faces.area(f) / faces.area()));
            }
        }
    }

    /** The values at a face's corners, interpolated from the corners of its original triangle. */
    private static double[] atCorners(Faces faces, int face, IntToDoubleFunction original) {
        double[] of = new double[3];
        for (int k = 0; k < 3; k++) {
            double[] weight = weights(faces, face, k);
            for (int j = 0; j < 3; j++) {
                of[k] += weight[j] * original.applyAsDouble(j);
            }
        }
        return of;
    }

    /** Barycentric weights of the original triangle's corners at corner k of a face. */
    private static double[] weights(Faces faces, int face, int k) {
        double[] weights = new double[3];
        if (!faces.isPiece(face)) {
            weights[faces.side(face) % 2 == 0 || k == 0 ? k : 3 - k] = 1;
            return weights;
        }
        Vec3 p = faces.sceneCorner(face, k);
        Vec3[] from = new Vec3[3];
        Arrays.setAll(from, j -> faces.scene().corner(faces.triangle(face), j).minus(p));
        Vec3 n = from[1].minus(from[0]).cross(from[2].minus(from[0]));
        Arrays.setAll(weights, j -> from[(j + 1) % 3].cross(from[(j + 2) % 3]).dot(n) / n.dot(n));
        return weights;
    }

    boolean has(int face) {
        return maps != null && maps[face] != null;
    }

    /** The mean over a face; the surface's value where the quantity is constant. */
    double mean(int face, int colour, Rgb everywhere) {
        return at(face, NodePath.FACE, colour, everywhere.channel(colour));
    }

    /** The mean over a node; {@code everywhere} where the quantity is constant on the face. */
    double at(int face, long path, int colour, double everywhere) {
        return maps == null || maps[face] == null ? everywhere : maps[face].at(path, colour);
    }

    /** Mixes the means over the nodes of a face into a digest; leaves it where the quantity is constant on the face. */
    long digest(long before, int face) {
        return has(face) ? maps[face].digest(before) : before;
    }
}
