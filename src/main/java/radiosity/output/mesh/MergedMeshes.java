package radiosity.output.mesh;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import radiosity.scene.Camera;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Units;
import radiosity.scene.Vec3;
import radiosity.solution.EnergyLedger;
import radiosity.solution.SavedState;
import radiosity.solution.Solution;

/** Merges the meshes of a scene file into one solution in which each element is its own original triangle. */
public final class MergedMeshes {

    private MergedMeshes() { }

    /**
     * The merged meshes as a solution of one layer, without lights, hierarchy and saved state. Surfaces of equal name
     * become one surface; a reflectance that varies over a surface is replaced by the surface's mean.
     *
     * @param meshes not modified
     * @param origin added to the positions of all meshes, scene units
     * @param units  of the meshes' numbers
     */
    public static Solution solution(List<Mesh> meshes, Vec3 origin, String name, int shots, int rounds,
                                    double unshotFlux, EnergyLedger ledger, Optional<Camera> camera, Units units) {
        double[] o = {origin.x(), origin.y(), origin.z()};
        Map<String, Integer> surfaceIndex = new HashMap<>();
        List<Surface> surfaces = new ArrayList<>();
        int vertices = meshes.stream().mapToInt(Mesh::vertices).sum();
        int elements = meshes.stream().mapToInt(Mesh::elements).sum();
        double[] positions = new double[3 * vertices];
        double[] irradiance = new double[3 * vertices];
        int[] corners = new int[3 * elements];
        // As corners, but with corners 1 and 2 of backs swapped: the front side of the original triangles.
        int[] original = new int[3 * elements];
        int[] surfaceOf = new int[elements];
        int[] faceOf = new int[elements];
        int vertex = 0;
        int element = 0;
        for (Mesh mesh : meshes) {
            for (int i = 0; i < mesh.positions().length; i++) {
                positions[3 * vertex + i] = mesh.positions()[i] + o[i % 3];
                irradiance[3 * vertex + i] = mesh.irradiance()[i];
            }
            int surface = surfaceIndex.computeIfAbsent(mesh.surface().name(), key -> {
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
            vertex += mesh.vertices();
            element += mesh.elements();
        }
        Scene scene = new Scene(name, positions, original, surfaceOf, surfaces, List.of(), camera).with(units);
        return new Solution(scene, 3, positions, irradiance, corners, faceOf, shots, rounds, unshotFlux, ledger,
                SavedState.NONE);
    }
}
