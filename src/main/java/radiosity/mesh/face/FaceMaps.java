package radiosity.mesh.face;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.Function;
import radiosity.scene.Raster;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/** The pictures of one quantity, exitance or reflectance, on all faces that have one. */
final class FaceMaps {

    /** 1 per face, or null; null where no face has any. */
    private final FaceMap[] maps;

    /** @param kind the quantity */
    FaceMaps(Faces faces, Function<Surface.Maps, Optional<Raster>> kind) {
        Scene scene = faces.scene();
        boolean none = scene.surfaces().stream().allMatch(surface -> kind.apply(surface.maps()).isEmpty());
        maps = none ? null : new FaceMap[faces.count()];
        for (int f = 0; !none && f < maps.length; f++) {
            int triangle = faces.triangle(f);
            Optional<Raster> raster = kind.apply(scene.surface(triangle).maps());
            if (raster.isPresent() && scene.isMapped(triangle)) {
                maps[f] = new FaceMap(raster.get(), coordinates(faces, f, 0), coordinates(faces, f, 1));
            }
        }
    }

    /** u (0) or v (1) of a face's corners. */
    private static double[] coordinates(Faces faces, int face, int which) {
        double[] of = new double[3];
        for (int k = 0; k < 3; k++) {
            double[] weight = weights(faces, face, k);
            for (int j = 0; j < 3; j++) {
                of[k] += weight[j] * faces.scene().textureCoordinates()[6 * faces.triangle(face) + 2 * j + which];
            }
        }
        return of;
    }

    /** Weights of its original triangle's corners at corner k of a face. */
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

    /** In the mean over a face; the surface's where it has no picture. */
    double mean(int face, int colour, Rgb everywhere) {
        return at(face, NodePath.FACE, colour, everywhere.channel(colour));
    }

    /** In the mean over a node. */
    double at(int face, long path, int colour, double everywhere) {
        return maps == null || maps[face] == null ? everywhere : maps[face].at(path, colour);
    }
}
