package radiosity.mesh.face;

import java.util.function.IntPredicate;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.util.ArraySize;
import radiosity.util.Hash;

/** Exitance and reflectance of faces: the mean over each face and over the nodes below it. */
final class FaceMaterials {

    private final int colours;
    private final int channels;
    /** channels per face: mean exitance, W/m²; and mean reflectance. */
    private final double[] exitance;
    private final double[] reflectance;
    private final FaceMaps exitanceMaps;
    private final FaceMaps reflectanceMaps;

    FaceMaterials(Faces faces, Channels kinds) {
        Scene scene = faces.scene();
        colours = kinds.colours;
        channels = kinds.colours * kinds.layers();
        exitance = new double[ArraySize.of("exitance of faces in " + channels + " channels", channels, faces.count())];
        reflectance = new double[exitance.length];
        exitanceMaps = new FaceMaps(faces, Surface.Maps::exitance, Surface::exitance, false);
        reflectanceMaps = new FaceMaps(faces, Surface.Maps::reflectance, Surface::reflectance, true);
        for (int f = 0; f < faces.count(); f++) {
            int s = scene.surfaceOf()[faces.triangle(f)];
            Surface surface = scene.surfaces().get(s);
            for (int c = 0; c < channels; c++) {
                exitance[channels * f + c] = kinds.isOf(true, s, c)
                        ? exitanceMaps.mean(f, c % colours, surface.exitance()) : 0;
                reflectance[channels * f + c] = reflectanceMaps.mean(f, c % colours, surface.reflectance());
            }
        }
    }

    void darken(IntPredicate hidden) {
        for (int i = 0; i < exitance.length; i++) {
            exitance[i] = exitance[i] > 0 && hidden.test(i / channels) ? 0 : exitance[i];
        }
    }

    double exitance(int face, int channel) {
        return exitance[channels * face + channel];
    }

    double reflectance(int face, int channel) {
        return reflectance[channels * face + channel];
    }

    boolean isMapped(int face) {
        return exitanceMaps.has(face) || reflectanceMaps.has(face);
    }

    double exitance(int face, long path, int channel) {
        double whole = exitance[channels * face + channel];
        return whole == 0 ? 0 : exitanceMaps.at(face, path, channel % colours, whole);
    }

    double reflectance(int face, long path, int channel) {
        return reflectanceMaps.at(face, path, channel % colours, reflectance[channels * face + channel]);
    }

    /** Mixes the exitance and reflectance of a face into a digest. */
    long digest(long before, int face) {
        long digest = before;
        for (int i = channels * face; i < channels * (face + 1); i++) {
            digest = Hash.mix(digest, Double.doubleToLongBits(exitance[i]));
            digest = Hash.mix(digest, Double.doubleToLongBits(reflectance[i]));
        }
        return reflectanceMaps.digest(exitanceMaps.digest(digest, face), face);
    }
}
