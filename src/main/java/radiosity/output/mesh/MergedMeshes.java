package radiosity.output.mesh;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import radiosity.scene.Camera;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.EnergyLedger;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;

/**
 * Merges the meshes of a scene file into one solution in which each element is its own original triangle. Surfaces of
 * equal name become one surface; a reflectance that varies over a surface is replaced by the surface's mean.
 */
public final class MergedMeshes {

    private final Vec3 origin;
    private final Map<String, Integer> surfaceIndex = new LinkedHashMap<>();
    private final List<Surface> surfaces = new ArrayList<>();
    private final double[] positions;
    private final double[] irradiance;
    private final int[] corners;
    /** As {@link #corners}, but with corners 1 and 2 of backs swapped: the front side of the original triangles. */
    private final int[] original;
    private final int[] surfaceOf;
    private final int[] faceOf;

    /** @param origin added to the positions of all meshes, scene units */
    public MergedMeshes(List<Mesh> meshes, Vec3 origin) {
        this.origin = origin;
        int vertices = meshes.stream().mapToInt(Mesh::vertices).sum();
        int elements = meshes.stream().mapToInt(Mesh::elements).sum();
        positions = new double[3 * vertices];
        irradiance = new double[3 * vertices];
        corners = new int[3 * elements];
        original = new int[3 * elements];
        surfaceOf = new int[elements];
        faceOf = new int[elements];
        int vertex = 0;
        int element = 0;
        for (Mesh mesh : meshes) {
            append(mesh, vertex, element);
            vertex += mesh.vertices();
            element += mesh.elements();
        }
    }

    private void append(Mesh mesh, int vertex, int element) {
        double[] o = {origin.x(), origin.y(), origin.z()};
        for (int i = 0; i < mesh.positions().length; i++) {
            positions[3 * vertex + i] = mesh.positions()[i] + o[i % 3];
            irradiance[3 * vertex + i] = mesh.irradiance()[i];
        }
        int surface = surfaceIndex.computeIfAbsent(mesh.surface().name(), name -> {
            surfaces.add(mesh.surface());
            return surfaces.size() - 1;
        });
        for (int i = 0; i < mesh.corners().length; i++) {
            int turned = mesh.back() ? i - i % 3 + (3 - i % 3) % 3 : i;
            corners[3 * element + i] = mesh.corners()[i] + vertex;
            original[3 * element + turned] = mesh.corners()[i] + vertex;
            surfaceOf[element + i / 3] = surface;
            faceOf[element + i / 3] = 2 * (element + i / 3) + (mesh.back() ? 1 : 0);
        }
    }

    /** The merged meshes as a solution of one layer, without lights, hierarchy and saved state. */
    public Solution solution(String name, int shots, int rounds, double unshotFlux, EnergyLedger ledger,
                      Optional<Camera> camera) {
        Scene scene = new Scene(name, positions, original, surfaceOf, surfaces, List.of(), camera);
        return new Solution(scene, 3, positions, irradiance, corners, faceOf, shots, rounds, unshotFlux, ledger,
                SavedState.NONE);
    }
}
