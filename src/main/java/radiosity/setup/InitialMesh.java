package radiosity.setup;

import com.fasterxml.jackson.core.io.NumberOutput;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import radiosity.formfactor.EnteringLight;
import radiosity.formfactor.EscapingLight;
import radiosity.formfactor.FormFactorCalculators;
import radiosity.formfactor.LightSources;
import radiosity.formfactor.UnseenLamps;
import radiosity.mesh.Block;
import radiosity.mesh.CoincidentFaces;
import radiosity.mesh.InteriorTest;
import radiosity.mesh.Patcher;
import radiosity.mesh.RepresentativeFaces;
import radiosity.mesh.cut.DiscontinuityMesher;
import radiosity.mesh.cut.EdgeMatcher;
import radiosity.mesh.cut.QuadSplitter;
import radiosity.mesh.cut.ScenePieces;
import radiosity.mesh.face.Faces;
import radiosity.mesh.room.ClosedRooms;
import radiosity.mesh.room.DarkCavities;
import radiosity.mesh.room.EnclosedTriangles;
import radiosity.protocol.Rounding;
import radiosity.protocol.Shot;
import radiosity.scene.ImageBudget;
import radiosity.scene.Lamp;
import radiosity.scene.Light;
import radiosity.scene.Luminaire;
import radiosity.scene.LuminousIntensity;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Vec3;
import radiosity.settings.Accuracy;
import radiosity.settings.FormFactors;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.util.Hash;
import radiosity.visibility.RadiosityBounds;
import radiosity.visibility.Solids;

/** World set-up (section 4.2 of the paper): data that follow from scene and settings alone, the same on every host. */
public final class InitialMesh {

    /** Patches where no patch area is given: for schedule PAPER, for those of small scenes, and for a coarse mesh. */
    private static final int PATCHES = 6000;
    private static final int FEW_PATCHES = 2000;
    private static final int COARSE_PATCHES = 600;
    /** Version of the saved state of calculations: a state with another version is refused. */
    private static final int STATE = 14;
    /** Regular expression that splits a fingerprint before each option. */
    private static final String PARTS = ",? (?=-)";
    /**
     * Approximate number of blocks without prediction, with or without a threshold for the division of elements: with
     * one, each vertex on a border between two hosts is computed by both of them, see {@link #gathersOnce}.
     */
    private static final int BLOCKS = 256;
    /** Approximate number of blocks with prediction: blocks are small, so that all hosts can be given equal work. */
    private static final int FINE_BLOCKS = 1024;
    /** Approximate number of clusters of patches that shoot together. */
    private static final int CLUSTERS = 128;
    /** Reflectance above which the rounding of shots to floats would show in the result. */
    private static final double WHITE = 0.98;
    /** Sample points per shooter where no number is given: by the schedules of the paper, and with prediction. */
    private static final int RAYS = 4;
    private static final int FEW_RAYS = 1;

    /** Part of the rays of {@link EnteringLight} that tells about how bright a scene is. */
    private static final double FEW_OF_ALL_RAYS = 1. / 16;

    /** The scene as it was read. */
    public final Scene original;
    /**
     * The original scene with images as {@link ImageBudget} leaves them; with prediction, its long
     * quadrangles are cut, and its triangles at T-vertices.
     */
    public final Scene scene;
    /** 1 per triangle of {@link #scene}: the triangle of the original scene that it is, or is a piece of. */
    public final int[] origins;
    public final RadiositySettings settings;
    public final Faces faces;
    /** Tree of the triangles that cast shadows. */
    public final RadiosityBounds bounds;
    public final CoincidentFaces coincident;
    public final ClosedRooms rooms;
    public final InteriorTest interior;
    public final Patcher patcher;
    public final Clusters clusters;
    /** The blocks that are dealt to owners. */
    public final List<Block> blocks;
    /** The mesh on which future light is predicted; its patches are about as many as the prediction needs. */
    public final Patcher coarse;
    /** The faces of the coarse mesh that represent others in the prediction. */
    public final RepresentativeFaces representatives;
    /** Flux that surfaces emit, one per channel, W. */
    public final double[] emitted;

    /** How radiosities to be shot are rounded for sending. */
    public final Rounding rounding;

    /** Finds the light that arrives nowhere. */
    public final EscapingLight escaping;
    /** See {@link #firstIrradiance()}; null before its first call. */
    private double[] firstIrradiance;
    /** See {@link #allLightFlux}; null before its first call. */
    private double[] allLightFlux;

    public InitialMesh(Scene scene, RadiositySettings settings) {
        this.settings = settings;
        original = scene;
        ScenePieces.Cut cut = QuadSplitter.cut(ImageBudget.forLight(scene), quadrangleArea());
        cut = predicts() ? EdgeMatcher.match(cut) : cut;
        this.scene = cut.scene();
        origins = cut.origin();
        Faces sides = new Faces(this.scene, settings.layers());
        faces = predicts() ? withoutDarkPlaces(sides) : sides;
        bounds = new RadiosityBounds(faces.occluders());
        coincident = new CoincidentFaces(faces, bounds);
        Solids solids = new Solids(bounds, faces.fronts());
        rooms = new ClosedRooms(faces, face -> isBuried(solids, face), coincident.covered());
        interior = new InteriorTest(faces, solids, coincident, rooms::isHidden);
        escaping = new EscapingLight(faces, bounds, solids, interior);
        faces.darken(rooms::isHidden);
        boolean mayBeCovered = predicts() && !rooms.isPlain();
        CoveredFaces covered = mayBeCovered ? new CoveredFaces(faces, bounds, solids, coincident) : null;
        if (mayBeCovered) {
            faces.cover(covered::visibleShare);
        }
        double squared = faces.size() * faces.size();
        double area = settings.patchArea() > 0 ? settings.patchArea() / squared
                : Patcher.areaFor(faces, patches());
        patcher = new Patcher(faces, area, mayBeCovered ? covered
                : (face, isSmall) -> predicts() && isSmall ? faces.middle(face) : null);
        clusters = new Clusters(patcher, predicts() ? CLUSTERS : BLOCKS, predicts() ? FINE_BLOCKS : BLOCKS);
        blocks = clusters.blocks;
        coarse = solvesAtOnce() ? patcher : patcher.coarser(clusters.clusters, COARSE_PATCHES);
        representatives = new RepresentativeFaces(coarse, clusters.clusters);
        boolean white = scene.surfaces().stream()
                .anyMatch(s -> s.reflectance().max() > WHITE || s.maps().reflectance().isPresent());
        rounding = new Rounding(white, shootsClusters() && !settings.layers());
        emitted = new double[faces.channels()];
        for (int f = 0; f < faces.count(); f++) {
            for (int c = 0; c < emitted.length; c++) {
                emitted[c] += faces.exitance(f, c) * faces.exposedArea(f) * squared;
            }
        }
    }

    /** The pieces of faces, without those that no light reaches inside of closed bodies. */
    private static Faces withoutDarkPlaces(Faces sides) {
        Faces fronts = sides.without(DarkCavities.of(sides));
        Faces pieces = DiscontinuityMesher.cut(fronts);
        pieces.enclose(EnclosedTriangles.of(fronts));
        return pieces;
    }

    /** Area above which the triangles of long quadrangles are cut, square scene units; infinite without prediction. */
    private double quadrangleArea() {
        return !predicts() ? Double.POSITIVE_INFINITY
                : settings.patchArea() > 0 ? settings.patchArea() : original.area() / COARSE_PATCHES;
    }

    /** Whether the middle of a face lies inside a solid. */
    private boolean isBuried(Solids solids, int face) {
        float[] middle = faces.middle(face);
        return solids.hold(middle[0], middle[1], middle[2],
                faces.normal(face, 0), faces.normal(face, 1), faces.normal(face, 2));
    }

    /** The lamps whose light arrives nowhere, found by rays. */
    public List<Lamp> unseenLamps() {
        return new UnseenLamps(faces, bounds, escaping).list();
    }

    private int patches() {
        return predicts() ? COARSE_PATCHES : settings.schedule().isForSmallScenes() ? FEW_PATCHES : PATCHES;
    }

    /** Whether the coarse mesh is the mesh itself, so that the solution of the coarse system is the result. */
    public boolean solvesAtOnce() {
        return settings.schedule() == Schedule.MATRIX;
    }

    /** Whether the patches of a cluster shoot together; only with rays, as projecting a cluster would take long. */
    public boolean shootsClusters() {
        return predicts() && settings.factors() == FormFactors.RAYCAST;
    }

    /**
     * Whether at a vertex that several hosts share only one host gathers, for all of them: not where a threshold
     * divides elements between rounds.
     */
    public boolean gathersOnce() {
        return (predicts() || settings.schedule() == Schedule.PAPER) && Double.isInfinite(settings.meshing());
    }

    /** Flux that arrives from sources without geometry but sun and sky, one per channel, W; the same for every mesh. */
    public double[] lightFlux() {
        return new LightSources(faces, bounds).flux();
    }

    /** The same of all sources without geometry, the sun and skies among them; found at the first call. */
    public synchronized double[] allLightFlux() {
        if (allLightFlux == null) {
            double[] inside = lightFlux();
            double[] outside = new EnteringLight(faces, bounds).flux(1);
            allLightFlux = new double[inside.length];
            Arrays.setAll(allLightFlux, c -> inside[c] + outside[c]);
        }
        return allLightFlux.clone();
    }

    /**
     * How closely a point looks at skies: as closely as it looks at surfaces, if all faces that light from outside can
     * reach had the irradiance at first light.
     *
     * @param tolerance irradiance that one ray may carry, relative to the mean, above 0
     * @param key       number from which the directions of rays follow
     */
    public LightSources.SkyRays skyRays(double tolerance, long key) {
        return !predicts() || !hasSky() ? LightSources.SkyRays.EXACT
                : new LightSources.SkyRays(tolerance, firstIrradiance(), key);
    }

    private boolean hasSky() {
        return scene.lights().stream().anyMatch(light -> light.kind().isSky());
    }

    /**
     * Mean irradiance by surfaces that emit, the sun and skies, before reflection, on faces outside of closed rooms:
     * one per channel, W/m²; about.
     */
    private synchronized double[] firstIrradiance() {
        if (firstIrradiance == null) {
            double[] entering = new EnteringLight(faces, bounds).flux(FEW_OF_ALL_RAYS);
            double area = 0;
            for (int f = 0; f < faces.count(); f++) {
                boolean isOpen = rooms.room(f) < 0;
                area += isOpen ? faces.area(f) : 0;
                for (int c = 0; isOpen && c < entering.length; c++) {
                    entering[c] += faces.exitance(f, c) * faces.exposedArea(f) * faces.size() * faces.size();
                }
            }
            double open = area * faces.size() * faces.size();
            firstIrradiance = Arrays.stream(entering).map(flux -> open > 0 ? flux / open : 0).toArray();
        }
        return firstIrradiance;
    }

    /**
     * Flux of a shot that arrives nowhere, found by rays: see {@link EscapingLight#flux}.
     *
     * @param perRay |flux| for which one ray stands, W, above 0
     * @return per channel the escaping flux, W; then per channel the variance of that estimate, W²
     */
    public double[] escapingFlux(Shot shot, double perRay) {
        double squared = faces.size() * faces.size();
        double[] flux = escaping.flux(shot.trees(), perRay / squared);
        for (int c = 0; c < flux.length; c++) {
            flux[c] *= c < faces.channels() ? squared : squared * squared;
        }
        return flux;
    }

    /** Whether all flux that is shot must be received: with prediction, in one closed room without covered faces. */
    public boolean conserves() {
        return predicts() && rooms.isPlain();
    }

    /** Whether the sun or a sky lights the scene: how much of their light arrives depends on the mesh. */
    public boolean isLitFromOutside() {
        return scene.lights().stream().anyMatch(light -> light.kind().isOutside());
    }

    public boolean predicts() {
        return settings.schedule() == Schedule.PREDICT;
    }

    /** Approximate number of entries that one shot adds to the rows of the coarse system. */
    public int entriesPerShot() {
        double all = (double) coarse.patches() * coarse.patches();
        return (int) (all / (solvesAtOnce() ? coarse.patches() : clusters.clusters.size()));
    }

    /** Sample points per shooter, or cells along an edge of a projection, see {@link FormFactors}. */
    public int rays() {
        return settings.rays() > 0 ? settings.rays()
                : FormFactorCalculators.defaultRays(settings.factors(), predicts() ? FEW_RAYS : RAYS);
    }

    /** Largest area of a patch, square scene units. */
    public double patchArea() {
        return patcher.patchArea() * faces.size() * faces.size();
    }

    /** Approximate flux in the scene, W: the scale of exact sums of flux. */
    public double fluxScale() {
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

    /** All that two calculations must have in common for one to continue the other: scene, blocks and settings. */
    public String fingerprint() {
        return String.format(Locale.ROOT, "scene %016x in %d blocks, state %d, -pa %s -nr %d -mt %s --schedule %s",
                digest(), blocks.size(), STATE, text(patchArea()), rays(), text(settings.meshing()),
                settings.schedule().name().toLowerCase(Locale.ROOT))
                + (settings.layers() ? " --layers" : "")
                + (settings.factors() == FormFactors.RAYCAST ? ""
                : " --form-factors " + settings.factors().name().toLowerCase(Locale.ROOT))
                + (predicts() ? accuracyText() : "");
    }

    /** The accuracy in per cent, and the tolerance and mesh error that follow from it. */
    private String accuracyText() {
        return String.format(Locale.ROOT, " --accuracy %.6g%% (first tolerance %s, first mesh error %s)",
                100 * Accuracy.of(settings.tolerance()), tolerance(), meshError());
    }

    /** With prediction: the relative error of the radiosity that is aimed at. */
    public double accuracy() {
        return Accuracy.of(tolerance());
    }

    /** With prediction: largest irradiance that one ray may carry, relative to the mean radiosity. */
    public double tolerance() {
        return settings.tolerance() > 0 ? settings.tolerance() : Accuracy.tolerance(Accuracy.DEFAULT);
    }

    /** With prediction: interpolation error that one element may add to the whole, relative to the mean radiosity. */
    public double meshError() {
        return settings.meshError() > 0 ? settings.meshError() : Accuracy.meshError(Accuracy.DEFAULT);
    }

    /**
     * Checks that a calculation with a saved fingerprint can continue on this mesh.
     *
     * @throws SceneFormatException where the fingerprints differ; the message names the differences
     *                              of settings
     */
    public void checkFingerprint(String saved) throws SceneFormatException {
        List<String> own = List.of(fingerprint().split(PARTS));
        List<String> others = List.of(saved.split(PARTS));
        String scene = others.get(0);
        if (!scene.equals(own.get(0))) {
            throw new SceneFormatException("the saved calculation", "", "the same scene and settings",
                    scene.endsWith("state " + STATE) ? "one of another scene"
                            : "one that another version of the program has made");
        }
        if (!own.equals(others)) {
            throw new SceneFormatException("the saved calculation", "", "the same scene and settings ("
                    + difference(own, others) + ")", difference(others, own));
        }
    }

    private static String difference(List<String> of, List<String> from) {
        String parts = of.stream().filter(part -> !from.contains(part)).collect(Collectors.joining(" "));
        return parts.isEmpty() ? "none" : parts;
    }

    /** The shortest digits for a number; the digits of Double.toString differ between JDK 17 and JDK 19. */
    private static String text(double number) {
        return NumberOutput.toString(number, true);
    }

    /** Mixes a light into a digest, without its name, which hosts do not receive. */
    private static long digest(long before, Light light) {
        long digest = Hash.mix(before, light.kind().ordinal());
        Vec3 power = new Vec3(light.power().r(), light.power().g(), light.power().b());
        Vec3 shape = new Vec3(light.range(), light.cone(), light.edge());
        for (Vec3 v : List.of(power, light.position(), light.direction(), light.right(), light.up(), shape)) {
            digest = Hash.mix(digest, Double.doubleToLongBits(v.x()));
            digest = Hash.mix(digest, Double.doubleToLongBits(v.y()));
            digest = Hash.mix(digest, Double.doubleToLongBits(v.z()));
        }
        return light.luminaire().isEmpty() ? digest : digest(digest, light.luminaire().get());
    }

    private static long digest(long before, Luminaire lamp) {
        double[] shape = {lamp.zero().x(), lamp.zero().y(), lamp.zero().z(), lamp.length(), lamp.width()};
        LuminousIntensity web = lamp.intensity();
        long digest = Hash.mix(before, web.type().ordinal());
        for (double[] values : List.of(web.horizontal(), web.vertical(), web.candela(), shape)) {
            for (double x : values) {
                digest = Hash.mix(digest, Double.doubleToLongBits(x));
            }
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
            digest = faces.digest(digest, f);
        }
        return digest;
    }
}
