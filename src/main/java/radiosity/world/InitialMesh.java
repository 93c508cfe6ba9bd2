package radiosity.world;

import com.fasterxml.jackson.core.io.NumberOutput;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import radiosity.formfactor.FormFactorCalculators;
import radiosity.formfactor.FormFactors;
import radiosity.patch.Block;
import radiosity.patch.Cutting;
import radiosity.patch.Faces;
import radiosity.patch.Fellows;
import radiosity.patch.Hash;
import radiosity.patch.Patcher;
import radiosity.patch.Rooms;
import radiosity.patch.Strips;
import radiosity.scene.Light;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Vec3;
import radiosity.visibility.RadiosityBounds;

/** World set-up (section 4.2 of the paper): what follows from scene and settings alone, the same on every host. */
final class InitialMesh {

    /** Patches of a scene for which no patch area is given: for the paper's schedule, its others, and prediction. */
    private static final int PATCHES = 6000;
    private static final int FEW_PATCHES = 2000;
    private static final int COARSE_PATCHES = 600;
    /** Where a fingerprint is split into scene and options. */
    private static final String PARTS = ",? (?=-)";
    /** What is shared out: where borders cost time, and where every point is computed once. */
    private static final int BLOCKS = 256;
    private static final int FINE_BLOCKS = 1024;
    /** What shoots together. */
    private static final int CLUSTERS = 128;
    /** Reflectance above which the rounding of floats would show. */
    private static final double WHITE = 0.98;
    /** Sample points per shooter where no number is given, likewise. */
    private static final int RAYS = 4;
    private static final int FEW_RAYS = 1;

    /** With its long quadrangles cut. */
    final Scene scene;
    final RadiositySettings settings;
    final Faces faces;
    /** Closed rooms. */
    final Rooms rooms;
    final Patcher patcher;
    final Clusters clusters;
    /** What is shared out. */
    final List<Block> blocks;
    /** A mesh that goes no deeper than is needed to foresee what light will become. */
    final Patcher coarse;
    /** Whose light stands for whose in that. */
    final Fellows fellows;
    /** Flux that surfaces emit, one per channel, W. */
    final double[] emitted;

    /** How a radiosity to be shot is sent. */
    final Rounding rounding;

    private RadiosityBounds bounds;

    InitialMesh(Scene scene, RadiositySettings settings) {
        this.settings = settings;
        this.scene = predicts() ? Strips.cut(scene, settings.patchArea() > 0 ? settings.patchArea()
                : scene.area() / COARSE_PATCHES) : scene;
        Faces whole = new Faces(this.scene, settings.layers());
        faces = predicts() ? Cutting.cut(whole) : whole;
        rooms = new Rooms(faces, this::isBuried);
        faces.darken(rooms::isHidden);
        double squared = faces.size() * faces.size();
        double area = settings.patchArea() > 0 ? settings.patchArea() / squared
                : Patcher.areaFor(faces, patches());
        patcher = new Patcher(faces, area, predicts());
        clusters = new Clusters(patcher, predicts() ? CLUSTERS : BLOCKS, predicts() ? FINE_BLOCKS : BLOCKS);
        blocks = clusters.blocks;
        coarse = solvesAtOnce() ? patcher : patcher.coarser(clusters.clusters, COARSE_PATCHES);
        fellows = new Fellows(coarse, clusters.clusters);
        boolean white = scene.surfaces().stream()
                .anyMatch(s -> s.reflectance().max() > WHITE || s.maps().reflectance().isPresent());
        rounding = new Rounding(white, shootsClusters() && !settings.layers());
        emitted = new double[faces.channels()];
        for (int f = 0; f < faces.count(); f++) {
            for (int c = 0; c < emitted.length; c++) {
                emitted[c] += faces.exitance(f, c) * faces.area(f) * squared;
            }
        }
    }

    /** Whether the middle of a face lies inside a solid. */
    private boolean isBuried(int face) {
        float[] middle = new float[3];
        for (int i = 0; i < 9; i++) {
            middle[i % 3] += faces.corner(face, i / 3, i % 3) / 3;
        }
        return new Burial(faces, bounds(), f -> false).isBuried(middle, 0, face);
    }

    /** What stands between two points; made when it is first asked for, as a master without elements never does. */
    synchronized RadiosityBounds bounds() {
        if (bounds == null) {
            bounds = new RadiosityBounds(faces.occluders());
        }
        return bounds;
    }

    private int patches() {
        return predicts() ? COARSE_PATCHES : settings.schedule().isForSmallScenes() ? FEW_PATCHES : PATCHES;
    }

    /** Whether the coarse mesh is the mesh itself, and the coarse system the only one. */
    boolean solvesAtOnce() {
        return settings.schedule() == Schedule.MATRIX;
    }

    /** Whether the patches of a cluster shoot together; a projection would take long for so many at a time. */
    boolean shootsClusters() {
        return predicts() && settings.factors() == FormFactors.RAYCAST;
    }

    /** Whether at a point that several hosts have only one gathers, for all: where no elements are divided between rounds. */
    boolean gathersOnce() {
        return (predicts() || settings.schedule() == Schedule.PAPER) && Double.isInfinite(settings.meshing());
    }

    /** Whether then the master looks at patches between hosts: where everybody looks at all of them in every round. */
    boolean hasSeams() {
        return gathersOnce() && !predicts();
    }

    /** Whether all flux that is shot must be received. */
    boolean conserves() {
        return predicts() && rooms.isPlain();
    }

    boolean predicts() {
        return settings.schedule() == Schedule.PREDICT;
    }

    /** Entries of the coarse system's rows that come of one shot, about. */
    int entriesPerShot() {
        double all = (double) coarse.patches() * coarse.patches();
        return (int) (all / (solvesAtOnce() ? coarse.patches() : clusters.clusters.size()));
    }

    /** Sample points per shooting node, or cells, see {@link FormFactors}. */
    int rays() {
        return settings.rays() > 0 ? settings.rays()
                : FormFactorCalculators.defaultRays(settings.factors(), predicts() ? FEW_RAYS : RAYS);
    }

    /** Largest area of a patch, square scene units. */
    double patchArea() {
        return patcher.patchArea() * faces.size() * faces.size();
    }

    /** About as much flux as there is, W: what sums of flux are counted in. */
    double fluxScale() {
        double sum = 0;
        for (double e : emitted) {
            sum += e;
        }
        for (Light light : scene.lights()) {
            double range = light.kind() == Light.Kind.POINT || light.kind() == Light.Kind.SPOT ? light.range() : 0;
            sum += light.power().max() * (faces.area() * faces.size() * faces.size() + 4 * Math.PI * range * range);
        }
        return sum;
    }

    /** What two calculations must have in common for one to go on from the other. */
    String fingerprint() {
        return String.format(Locale.ROOT, "scene %016x in %d blocks, -pa %s -nr %d -mt %s --schedule %s", digest(),
                blocks.size(), text(patchArea()), rays(), text(settings.meshing()),
                settings.schedule().name().toLowerCase(Locale.ROOT))
                + (settings.layers() ? " --layers" : "")
                + (settings.factors() == FormFactors.RAYCAST ? ""
                : " --form-factors " + settings.factors().name().toLowerCase(Locale.ROOT))
                + (predicts() ? accuracy() : "");
    }

    /** In per cent, and as the two numbers that follow from that. */
    private String accuracy() {
        return String.format(Locale.ROOT, " --accuracy %.6g%% (tolerance %s, mesh error %s)",
                100 * Accuracy.of(settings.tolerance()), tolerance(), meshError());
    }

    /** With prediction: irradiance that one ray may carry, relative to the mean. */
    double tolerance() {
        return settings.tolerance() > 0 ? settings.tolerance() : Accuracy.tolerance(Accuracy.DEFAULT);
    }

    /** With prediction: error of interpolation that one element may add to the whole. */
    double meshError() {
        return settings.meshError() > 0 ? settings.meshError() : Accuracy.meshError(Accuracy.DEFAULT);
    }

    /**
     * Checks that a calculation with another mesh's fingerprint can go on with this one.
     *
     * @throws SceneFormatException that names the differences
     */
    void checkFingerprint(String saved) throws SceneFormatException {
        List<String> own = List.of(fingerprint().split(PARTS));
        List<String> others = List.of(saved.split(PARTS));
        if (!own.equals(others)) {
            throw new SceneFormatException("the saved calculation", "", "the same scene and settings ("
                    + difference(own, others) + ")", difference(others, own));
        }
    }

    private static String difference(List<String> of, List<String> from) {
        String parts = of.stream().filter(part -> !from.contains(part)).collect(Collectors.joining(" "));
        return parts.isEmpty() ? "none" : parts;
    }

    /** The shortest digits for a number; those of Double.toString differ between JDK 17 and JDK 19. */
    private static String text(double number) {
        return NumberOutput.toString(number, true);
    }

    /** By what it shines, not by its name, which hosts are not told. */
    private static long digest(long before, Light light) {
        long digest = Hash.mix(before, light.kind().ordinal());
        Vec3 power = new Vec3(light.power().r(), light.power().g(), light.power().b());
        Vec3 shape = new Vec3(light.range(), light.cone(), light.edge());
        for (Vec3 v : List.of(power, light.position(), light.direction(), light.right(), light.up(), shape)) {
            digest = Hash.mix(digest, Double.doubleToLongBits(v.x()));
            digest = Hash.mix(digest, Double.doubleToLongBits(v.y()));
            digest = Hash.mix(digest, Double.doubleToLongBits(v.z()));
        }
        return digest;
    }

    private long digest() {
        long digest = 0;
        for (double x : scene.points()) {
            digest = Hash.mix(digest, Double.doubleToLongBits(x));
        }
        for (int p : scene.corners()) {
            digest = Hash.mix(digest, p);
        }
        for (Light light : scene.lights()) {
            digest = digest(digest, light);
        }
        for (int f = 0; f < faces.count(); f++) {
            digest = Hash.mix(digest, faces.side(f));
            for (int c = 0; c < faces.channels(); c++) {
                digest = Hash.mix(digest, Double.doubleToLongBits(faces.exitance(f, c)));
                digest = Hash.mix(digest, Double.doubleToLongBits(faces.reflectance(f, c)));
            }
        }
        return digest;
    }
}
