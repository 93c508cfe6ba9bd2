package radiosity.output.lightmap;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import radiosity.output.image.Picture;
import radiosity.output.mesh.Elements;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;
import radiosity.util.DisjointSets;

/** Bakes the radiosity of all elements into one texture for each side of a surface (section 4.6 of the paper). */
public final class TextureBake {

    /** Largest width and height of a texture, texels. */
    public static final int LARGEST_TEXTURE = Atlas.LARGEST;

    /** Up to this width and height, texels, charts get as many texels as the images on them have pixels. */
    private static final int LARGEST_FOR_IMAGES = 2048;

    private final Solution solution;
    private final Vec3 origin;
    private final double samples;
    /** Connected, plane parts as sets of vertices; a part is named by its lowest vertex. */
    private final DisjointSets parts;

    /**
     * One side of a surface with all its triangles.
     *
     * @param surface   material of the side
     * @param back      whether this is the back of a two-sided surface
     * @param positions x, y, z relative to the origin, 3 per vertex, scene units; 3 vertices per original triangle
     * @param places    u, v in the texture, v downwards, 2 per vertex, in [0, 1]
     * @param radiosity the texture, W/m²
     */
    public record Baked(Surface surface, boolean back, float[] positions, float[] places, Picture radiosity) { }

    /**
     * @param origin  subtracted from all positions, scene units
     * @param samples texels per scene unit, above 0; a surface whose images are finer gets more
     */
    public TextureBake(Solution solution, Vec3 origin, double samples) {
        this.solution = solution;
        this.origin = origin;
        this.samples = samples;
        parts = Atlas.parts(solution);
    }

    /** Is given the sides of surfaces, one after the other. */
    public interface Taker {
        void take(Baked side) throws IOException;
    }

    /**
     * Bakes the sides of all surfaces, front before back, in the order of the scene's surfaces. A texture may take 805
     * MB, so each side is handed to the taker before the next one is baked, and is not kept here.
     *
     * @throws IOException if a texture would be wider or higher than {@value #LARGEST_TEXTURE} texels, or from the
     *         taker
     */
    public void bake(Taker taker) throws IOException {
        int[][] sides = Mesh.bySide(solution);
        for (int side = 0; side < sides.length; side++) {
            if (sides[side].length > 0) {
                taker.take(bake(solution.scene().surfaces().get(side >> 1), (side & 1) == 1, sides[side]));
            }
        }
    }

    private Baked bake(Surface surface, boolean back, int[] elements) throws IOException {
        Map<Integer, List<Integer>> byPart = new LinkedHashMap<>();
        for (int e : elements) {
            byPart.computeIfAbsent(parts.of(solution.corners()[3 * e]), p -> new ArrayList<>()).add(e);
        }
        List<List<Integer>> elementsOf = List.copyOf(byPart.values());
        List<List<Integer>> facesOf = elementsOf.stream()
                .map(part -> part.stream().map(e -> solution.faceOf()[e]).distinct().toList()).toList();
        Atlas atlas = atlas(facesOf);
        Texels texels = atlas.texels("-ut, surface " + surface.name());
        int corners = 3 * facesOf.stream().mapToInt(List::size).sum();
        float[] positions = new float[3 * corners];
        float[] places = new float[2 * corners];
        int corner = 0;
        atlas.draw(texels, solution, elementsOf, (e, v, w, irradiance) -> solution.scene()
                .material(solution.faceOf()[e] >> 1, Elements.point(solution, e, v, w)).radiosity(irradiance));
        for (int c = 0; c < elementsOf.size(); c++) {
            for (int face : facesOf.get(c)) {
                for (int k = 0; k < 3; k++) {
                    Vec3 p = Elements.corner(solution.scene(), face, k);
                    p.minus(origin).write(positions, 3 * corner);
                    atlas.place(c, p, places, 2 * corner++);
                }
            }
        }
        return new Baked(surface, back, positions, places, texels.padded(Chart.PAD));
    }

    /**
     * One chart per part, as fine as the images on the part; all charts coarser if they do not fit into one texture.
     *
     * @param facesOf the faces of each part
     */
    private Atlas atlas(List<List<Integer>> facesOf) {
        int most = LARGEST_FOR_IMAGES;
        Atlas atlas = atlas(facesOf, most);
        while (!atlas.fits() && most > 1) {
            most /= 2;
            atlas = atlas(facesOf, most);
        }
        return atlas;
    }

    /** @param most width and height, texels, up to which charts are made as fine as the images on them */
    private Atlas atlas(List<List<Integer>> facesOf, int most) {
        Scene scene = solution.scene();
        return new Atlas(facesOf.stream().map(faces -> {
            double finest = faces.stream().map(face -> face >> 1).filter(scene::isMapped)
                    .mapToDouble(scene::pixelsPerUnit).max().orElse(0);
            return Chart.of(scene, faces, samples, finest, most);
        }).toList());
    }
}
