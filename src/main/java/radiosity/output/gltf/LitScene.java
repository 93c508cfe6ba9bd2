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
import radiosity.scene.Vec3;
import radiosity.solution.EnergyLedger;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;
import radiosity.util.Aabb;

/**
 * What one walks through: surfaces with the light on them, and from where to begin.
 *
 * @param meshes   one per side of a surface
 * @param origin   what to add to the meshes' positions, scene units
 * @param camera   the scene's, or one chosen for it
 * @param lamps    whose light can be mixed anew; empty where the meshes have no layers
 * @param textures the same with its light in textures, if they were made
 * @param progress what has been calculated so far, in a few words
 */
public record LitScene(List<Mesh> meshes, Vec3 origin, Camera camera, List<Lamp> lamps,
                       Optional<Textures> textures, String progress) {

    /**
     * Light in textures.
     *
     * @param toneMapping how radiosity became their colours
     * @param meshes      one per side of a surface
     */
    public record Textures(ToneMapping toneMapping, List<TexturedMesh> meshes) {
        public Textures {
            meshes = List.copyOf(meshes);
        }
    }

    /** From where the shade of an unlit scene comes. */
    private static final Vec3 SHADE_FROM = new Vec3(0.4, 0.8, 0.45).unit();
    /** The least shade of a surface. */
    private static final double DARKEST = 0.4;
    private static final EnergyLedger NO_LEDGER = new EnergyLedger(new double[3], new double[3], new double[3],
            new double[3], new double[3]);

    public LitScene {
        meshes = List.copyOf(meshes);
        lamps = List.copyOf(lamps);
    }

    /**
     * The same scene with its lamps dimmed or coloured.
     *
     * @param factors of each lamp's light, at least 0
     */
    public LitScene mixed(List<Rgb> factors) {
        return new LitScene(meshes.stream().map(mesh -> mesh.mixed(lamps, factors)).toList(), origin, camera, lamps,
                textures, progress);
    }

    /**
     * Reads the light of a scene file.
     *
     * @throws radiosity.scene.SceneFormatException if it is not one, is cut off, or is of a newer program
     */
    public static LitScene read(Path path) throws IOException {
        try (SceneFile file = SceneFile.open(path)) {
            Optional<Camera> camera = file.camera();
            return new LitScene(file.meshes(), file.origin(),
                    camera.isPresent() ? camera.get() : DefaultCamera.of(file.solution()),
                    file.lamps(), textures(file), file.extras().get("shots") + " shots");
        }
    }

    /** What a solution shows, from a camera of choice to begin with. */
    public static LitScene of(Solution solution, Camera camera) {
        Solution closed = TJunctions.close(solution);
        Vec3 origin = Aabb.of(closed.positions()).centre();
        return new LitScene(Mesh.of(closed, origin), origin, camera, solution.lamps(), Optional.empty(),
                solution.shots() + " shots");
    }

    /** The same as a solution, for pictures: images of surfaces are there in the mean only. */
    public Solution solution() {
        return new MergedMeshes(meshes, origin).solution(progress, 0, 0, 0, NO_LEDGER, Optional.of(camera));
    }

    private static Optional<Textures> textures(SceneFile file) throws IOException {
        Optional<ToneMapping> toneMapping = file.textureToneMapping();
        return toneMapping.isEmpty() ? Optional.empty()
                : Optional.of(new Textures(toneMapping.get(), file.textures()));
    }

    /**
     * A scene before any light is calculated: surfaces in the colour of their reflectance (the mean of their images on
     * each triangle), lamps white. So that edges can be seen, what faces up and to the right is shown brighter. Meant
     * for an exposure of 1, without a curve.
     */
    public static LitScene unlit(Scene scene) {
        List<Surface> surfaces = scene.surfaces().stream().map(LitScene::unlit).toList();
        Solution solution = shaded(scene.with(surfaces, List.of()));
        Aabb box = Aabb.of(solution.positions());
        return new LitScene(Mesh.of(solution, box.centre()), box.centre(), DefaultCamera.of(solution),
                List.of(), Optional.empty(), "unlit");
    }

    private static Surface unlit(Surface surface) {
        Rgb exitance = surface.emits() ? Rgb.grey(1) : Rgb.BLACK;
        return new Surface(surface.name(), exitance, surface.reflectance(), surface.twoSided(), surface.textures(),
                new Surface.Maps(Optional.empty(), surface.maps().reflectance()));
    }

    /** Each side of each triangle is an element with vertices of its own. */
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
