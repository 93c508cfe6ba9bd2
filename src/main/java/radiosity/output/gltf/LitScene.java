package radiosity.output.gltf;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import radiosity.output.image.DefaultCamera;
import radiosity.output.image.ToneMapping;
import radiosity.output.mesh.Elements;
import radiosity.output.mesh.MergedMeshes;
import radiosity.output.mesh.Mesh;
import radiosity.output.mesh.TJunctions;
import radiosity.scene.Camera;
import radiosity.scene.Lamp;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Units;
import radiosity.scene.Vec3;
import radiosity.solution.EnergyLedger;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.util.Aabb;

/**
 * A scene to walk through: meshes with the light on them, and a camera to begin with.
 *
 * @param meshes   one per object and side of a surface
 * @param origin   to be added to the positions of all meshes, scene units
 * @param camera   the camera of the scene or, if the scene has none, a view chosen for it
 * @param lamps    in the order of the meshes' layers, to be mixed anew; empty if the meshes have no layers
 * @param textures the same surfaces with their light in textures, if the file has textures
 * @param progress number of shots, for the user
 * @param units    of the light and of lengths
 */
public record LitScene(List<Mesh> meshes, Vec3 origin, Camera camera, List<Lamp> lamps,
                       Optional<Textures> textures, String progress, Units units) {

    /**
     * Surfaces with their light in textures.
     *
     * @param toneMapping from radiosity to the colours of the textures
     * @param meshes      one per side of a surface
     */
    public record Textures(ToneMapping toneMapping, List<TexturedMesh> meshes) {
        public Textures {
            meshes = List.copyOf(meshes);
        }
    }

    /** Direction from which surfaces of an unlit scene are shaded. */
    private static final Vec3 SHADE_FROM = new Vec3(0.4, 0.8, 0.45).unit();
    /** Shade of a surface that faces away from {@link #SHADE_FROM}; a surface that faces it has a shade of 1. */
    private static final double DARKEST = 0.4;
    private static final EnergyLedger NO_LEDGER = new EnergyLedger(new double[3], new double[3], new double[3],
            new double[3], new double[3]);

    public LitScene {
        meshes = List.copyOf(meshes);
        lamps = List.copyOf(lamps);
    }

    /**
     * The scene with its lamps dimmed or coloured.
     *
     * @param factors for the light of each lamp, each channel at least 0
     */
    public LitScene mixed(List<Rgb> factors) {
        return new LitScene(meshes.stream().map(mesh -> mesh.mixed(lamps, factors)).toList(), origin, camera, lamps,
                textures, progress, units);
    }

    /**
     * Reads a scene file.
     *
     * @throws radiosity.scene.SceneFormatException if the file is no scene file, is cut off, or is of a newer program
     */
    public static LitScene read(Path path) throws IOException {
        try (SceneFile file = SceneFile.open(path)) {
            Optional<Camera> camera = file.camera();
            return new LitScene(file.meshes(), file.origin(),
                    camera.isPresent() ? camera.get() : DefaultCamera.of(file.solution()),
                    file.lamps(), textures(file), file.extras().get("shots") + " shots", file.units());
        }
    }

    /** The scene of a solution, seen from a given camera to begin with. */
    public static LitScene of(Solution solution, Camera camera) {
        Solution closed = TJunctions.close(solution);
        Vec3 origin = Aabb.of(closed.positions()).centre();
        return new LitScene(Mesh.of(closed, origin), origin, camera, solution.lamps(), Optional.empty(),
                solution.shots() + " shots", solution.scene().units());
    }

    /**
     * The scene as a solution, for pictures; reflectance that varies over a surface is replaced by the surface's mean.
     */
    public Solution solution() {
        return MergedMeshes.solution(meshes, origin, progress, 0, 0, 0, NO_LEDGER, Optional.of(camera),
                units);
    }

    private static Optional<Textures> textures(SceneFile file) throws IOException {
        Optional<ToneMapping> toneMapping = file.textureToneMapping();
        return toneMapping.isEmpty() ? Optional.empty()
                : Optional.of(new Textures(toneMapping.get(), file.textures()));
    }

    /**
     * A scene before any light is calculated: surfaces in the colour of their reflectance (on each triangle the mean of
     * its image), lamps white. Surfaces that face up and to the right are brighter, so that edges can be seen. Meant
     * for a linear tone mapping with an exposure of 1.
     */
    public static LitScene unlit(Scene scene) {
        List<Surface> surfaces = scene.surfaces().stream().map(LitScene::unlit).toList();
        Solution solution = shaded(scene.with(surfaces, List.of()));
        Aabb box = Aabb.of(solution.positions());
        return new LitScene(Mesh.of(solution, box.centre()), box.centre(), DefaultCamera.of(solution),
                List.of(), Optional.empty(), "unlit", scene.units());
    }

    private static Surface unlit(Surface surface) {
        Rgb exitance = surface.emits() ? Rgb.grey(1) : Rgb.BLACK;
        return new Surface(surface.name(), exitance, surface.reflectance(), surface.twoSided(), surface.textures(),
                new Surface.Maps(Optional.empty(), surface.maps().reflectance())).smoothed(surface.smoothing());
    }

    /** A solution whose elements are the sides of triangles, with vertices of their own and the shade as irradiance. */
    private static Solution shaded(Scene scene) {
        int[] faces = faces(scene);
        double[] positions = new double[9 * faces.length];
        double[] shade = new double[9 * faces.length];
        int[] corners = new int[3 * faces.length];
        for (int e = 0; e < faces.length; e++) {
            double itsShade = shade(scene, faces[e]);
            for (int k = 0; k < 3; k++) {
                Vec3 p = Elements.corner(scene, faces[e], k);
                int i = 3 * e + k;
                corners[i] = i;
                positions[3 * i] = p.x();
                positions[3 * i + 1] = p.y();
                positions[3 * i + 2] = p.z();
                Arrays.fill(shade, 3 * i, 3 * i + 3, itsShade);
            }
        }
        return new Solution(scene, 3, positions, shade, corners, faces, 0, 0, 0, NO_LEDGER, SavedState.NONE);
    }

    private static int[] faces(Scene scene) {
        int[] faces = new int[2 * scene.triangles()];
        int count = 0;
        for (int t = 0; t < scene.triangles(); t++) {
            faces[count++] = 2 * t;
            if (scene.surface(t).twoSided()) {
                faces[count++] = 2 * t + 1;
            }
        }
        return Arrays.copyOf(faces, count);
    }

    private static double shade(Scene scene, int face) {
        double cosine = scene.cross(face >> 1).unit().dot(SHADE_FROM) * ((face & 1) == 0 ? 1 : -1);
        return DARKEST + (1 - DARKEST) * (1 + cosine) / 2;
    }
}
