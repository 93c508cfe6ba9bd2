package radiosity.output.lightmap;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferByte;
import java.awt.image.Raster;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import radiosity.output.image.Picture;
import radiosity.output.image.PictureFormat;
import radiosity.output.mesh.Elements;
import radiosity.output.mesh.TJunctions;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Units;
import radiosity.solution.Solution;
import radiosity.util.DisjointSets;

/**
 * The irradiance of all original triangles in one texture. Coplanar neighbours share one chart. Of a two-sided surface
 * the texture shows the side that gets more light, because a triangle has one place in the texture.
 *
 * @param irradiance W/m² or lx, row by row from the top
 * @param places     u, v of each corner of each triangle of the scene, v downwards, 6 per triangle, in [0, 1]; 0 for
 *                   triangles without elements
 * @param samples    texels per scene unit
 * @param units      of the irradiance
 */
public record Lightmap(Picture irradiance, float[] places, double samples, Units units) {

    /** Number of texels that triangles cover where the user gives no density. */
    private static final double USUAL_TEXELS = 600_000;
    /** How often the density that is chosen for the user may be halved; then the texture is mostly margins. */
    private static final int MOST_HALVED = 6;

    /**
     * Bakes the lightmap of a solution.
     *
     * @param samples texels per scene unit, above 0; if empty, as many as cover about 600,000 texels, and fewer where a
     *                texture with so many would be too long
     * @throws IOException if the lightmap would be wider or higher than 8192 texels
     */
    public static Lightmap of(Solution solution, OptionalDouble samples) throws IOException {
        Solution closed = TJunctions.close(solution);
        double density = samples.orElseGet(() -> Math.sqrt(USUAL_TEXELS / solution.scene().area()));
        return new Baker(closed, density, samples.isEmpty()).bake();
    }

    /** Bakes one lightmap. */
    private static final class Baker {

        private final Solution solution;
        private final Scene scene;
        private double samples;
        private final boolean mayBeCoarser;
        /** The elements of each face. */
        private final Map<Integer, List<Integer>> elementsOf = new HashMap<>();

        /** @param mayBeCoarser whether there may be fewer samples than given, so that the texture is not too large */
        Baker(Solution solution, double samples, boolean mayBeCoarser) {
            this.solution = solution;
            this.samples = samples;
            this.mayBeCoarser = mayBeCoarser;
            scene = solution.scene();
            for (int e = 0; e < solution.elements(); e++) {
                elementsOf.computeIfAbsent(solution.faceOf()[e], f -> new ArrayList<>(2)).add(e);
            }
        }

        Lightmap bake() throws IOException {
            List<List<Integer>> parts = planeParts();
            Atlas atlas = atlas(parts);
            for (int i = 0; mayBeCoarser && !atlas.fits() && i < MOST_HALVED; i++) {
                samples /= 2;
                atlas = atlas(parts);
            }
            Texels texels = atlas.texels("--lightmap-texels");
            float[] places = new float[6 * scene.triangles()];
            atlas.draw(texels, solution, parts.stream()
                    .map(part -> litSide(part).stream().filter(e -> flux(e) > 0).toList()).toList(),
                    (e, v, w, irradiance) -> irradiance);
            for (int c = 0; c < parts.size(); c++) {
                for (int t : parts.get(c)) {
                    for (int k = 0; k < 3; k++) {
                        atlas.place(c, scene.corner(t, k), places, 6 * t + 2 * k);
                    }
                }
            }
            return new Lightmap(texels.padded(Chart.PAD), places, samples, scene.units());
        }

        private Atlas atlas(List<List<Integer>> parts) {
            return new Atlas(parts.stream().map(part -> Chart.of(scene, part.stream().map(t -> 2 * t).toList(),
                    samples, samples, Atlas.LARGEST)).toList());
        }

        /** Connected, coplanar groups of triangles; triangles too small to have elements are left out. */
        private List<List<Integer>> planeParts() {
            DisjointSets joined = Atlas.parts(solution);
            Map<Integer, List<Integer>> parts = new LinkedHashMap<>();
            for (int t = 0; t < scene.triangles(); t++) {
                List<Integer> elements = elementsOf.getOrDefault(2 * t, elementsOf.get(2 * t + 1));
                if (elements != null) {
                    int vertex = solution.corners()[3 * elements.get(0)];
                    parts.computeIfAbsent(joined.of(vertex), p -> new ArrayList<>(1)).add(t);
                }
            }
            return List.copyOf(parts.values());
        }

        /** The elements on the fronts of triangles, or on their backs if more light arrives there. */
        private List<Integer> litSide(List<Integer> triangles) {
            List<Integer> fronts = new ArrayList<>();
            List<Integer> backs = new ArrayList<>();
            for (int t : triangles) {
                fronts.addAll(elementsOf.getOrDefault(2 * t, List.of()));
                backs.addAll(elementsOf.getOrDefault(2 * t + 1, List.of()));
            }
            ToDoubleFunction<List<Integer>> light = elements -> elements.stream().mapToDouble(this::flux).sum();
            return light.applyAsDouble(backs) > light.applyAsDouble(fronts) ? backs : fronts;
        }

        /**
         * Six times the flux that arrives at an element, W, sum of channels. Elements under other objects have 0 and
         * are not drawn, so that their darkness is not mixed into what is seen beside them.
         */
        private double flux(int element) {
            double sum = 0;
            for (int k = 0; k < 3; k++) {
                Rgb h = solution.irradianceAt(solution.corners()[3 * element + k]);
                sum += h.r() + h.g() + h.b();
            }
            return sum * Elements.cross(solution, element).length();
        }
    }

    /**
     * Encodes the lightmap as a PNG of four 8-bit channels (RGBM): the irradiance of a channel is (channel alpha)²
     * range, with channel and alpha in [0, 1].
     *
     * @param range largest irradiance of all channels, W/m² or lx, above 0
     */
    public byte[] rgbm(double range) throws IOException {
        float[] light = irradiance.rgb();
        byte[] rgba = new byte[light.length / 3 * 4];
        for (int t = 0; t < light.length / 3; t++) {
            double[] root = new double[3];
            for (int c = 0; c < 3; c++) {
                root[c] = Math.min(1, Math.sqrt(Math.max(0, light[3 * t + c]) / range));
            }
            double most = Math.max(root[0], Math.max(root[1], root[2]));
            int alpha = Math.max(1, (int) Math.ceil(255 * most));
            for (int c = 0; c < 3; c++) {
                rgba[4 * t + c] = (byte) Math.round(255 * Math.min(1, root[c] * 255 / alpha));
            }
            rgba[4 * t + 3] = (byte) alpha;
        }
        return png(rgba);
    }

    private byte[] png(byte[] rgba) throws IOException {
        int width = irradiance.width();
        WritableRaster raster = Raster.createInterleavedRaster(new DataBufferByte(rgba, rgba.length), width,
                irradiance.height(), 4 * width, 4, new int[] {0, 1, 2, 3}, null);
        ColorModel colours = new ComponentColorModel(ColorSpace.getInstance(ColorSpace.CS_sRGB), true, false,
                Transparency.TRANSLUCENT, DataBuffer.TYPE_BYTE);
        return PictureFormat.png(new BufferedImage(colours, raster, false, null));
    }

    /** The largest irradiance of any channel, W/m² or lx; 1 where all is dark. */
    public double range() {
        return irradiance.most() > 0 ? irradiance.most() : 1;
    }
}
