package radiosity.input.obj;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import radiosity.input.assembly.Placing;
import radiosity.input.assembly.SceneDraft;
import radiosity.input.assembly.SmoothEdges;
import radiosity.input.assembly.TriangleMesh;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FileSearch;
import radiosity.input.file.FloatList;
import radiosity.input.file.IntList;
import radiosity.input.file.OpenedFile;
import radiosity.input.file.WorkBudget;
import radiosity.input.polygon.Polygons;
import radiosity.input.polygon.Triangulation;
import radiosity.scene.Affine;
import radiosity.scene.ImageMap;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneFormatException;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.ReadOptions;

/** Reads a Wavefront OBJ file and the material libraries that it names. */
public final class ObjReader {

    /** Largest distance from the origin / size of a scene whose coordinates are not stored relative to its centre. */
    private static final double FAR = 16;

    private final ReadOptions options;
    private final Diagnostics notes;
    private final SceneDraft draft;
    private final Materials materials;
    private final ObjParser file;
    private final List<Surface> surfaces = new ArrayList<>();
    /** Index of the surface in {@code surfaces}, by the index of the material. */
    private final Map<Integer, Integer> surfaceOf = new HashMap<>();
    private final List<TextureImage> imageOf = new ArrayList<>();
    /** 1 per surface: the material that it is made of. */
    private final List<Material> materialOf = new ArrayList<>();
    /** The surfaces of which the user was told that they reflect less than their colours say. */
    private final BitSet clipped = new BitSet();
    private final SmoothEdges edges = new SmoothEdges();
    private boolean textured;
    private double[] origin;
    private FloatList points;
    /** 1 per vertex: its index in the mesh that is being made, or -1. */
    private int[] local;

    private ObjReader(byte[] bytes, String name, FileSearch search, ReadOptions options, Diagnostics notes) {
        this.options = options;
        this.notes = notes;
        draft = new SceneDraft(name, true, options, notes);
        materials = new Materials(search, options, notes);
        file = new ObjParser(bytes, name.replaceFirst("(?i)\\.obj$", ""), options.up(), draft, notes);
    }

    /**
     * Reads a file and the libraries that it names.
     *
     * @param options  where libraries and images are searched, colour spaces, limits
     * @param warnings receives one line, with file and place, for each kind of content that was left out or repaired
     * @return a scene of at least one triangle
     * @throws SceneFormatException if the content cannot be used, or under {@code strict} at the first warning
     * @throws IOException          if a file cannot be read
     */
    public static Scene read(Path file, ReadOptions options, Consumer<String> warnings) throws IOException {
        OpenedFile opened = OpenedFile.of(file, options, warnings);
        return read(opened.bytes(), opened.name(), opened.search(), options, opened.notes());
    }

    /**
     * Makes a scene of the content of a file.
     *
     * @param bytes  the whole file
     * @param search finds the libraries and images that the file names
     */
    static Scene read(byte[] bytes, String name, FileSearch search, ReadOptions options, Diagnostics notes)
            throws IOException {
        ObjReader reader = new ObjReader(bytes, name, search, options, notes);
        reader.file.parse();
        reader.materials.read(reader.file.libraries);
        reader.place();
        WorkBudget work = new WorkBudget();
        for (Group group : reader.file.groups) {
            reader.add(group, work);
        }
        return reader.draft.scene(reader.edges.apply(reader.surfaces), List.of(), Optional.empty());
    }

    /** Converts the vertices to floats, relative to the scene's centre where the scene is far from the origin. */
    private void place() {
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        BitSet used = used();
        for (int i = 0; i < file.points.size(); i++) {
            double x = file.points.get(i);
            if (Double.isFinite(x) && used.get(i / 3)) {
                low[i % 3] = Math.min(low[i % 3], x);
                high[i % 3] = Math.max(high[i % 3], x);
            }
        }
        double size = 0;
        double farthest = 0;
        for (int k = 0; k < 3; k++) {
            size = Math.max(size, high[k] - low[k]);
            farthest = Math.max(farthest, Math.max(Math.abs(low[k]), Math.abs(high[k])));
        }
        origin = new double[3];
        for (int k = 0; k < 3 && size > 0 && farthest > FAR * size; k++) {
            origin[k] = (float) (low[k] / 2 + high[k] / 2);
        }
        points = new FloatList();
        for (int i = 0; i < file.points.size(); i++) {
            points.add((float) (file.points.get(i) - origin[i % 3]));
        }
        local = new int[points.size() / 3];
        Arrays.fill(local, -1);
    }

    /** The vertices of polygons; others, such as a survey point, are not part of the scene. */
    private BitSet used() {
        BitSet used = new BitSet();
        for (Group group : file.groups) {
            Polygons polygons = group.polygons();
            for (int i = 0; i < (polygons.size() == 0 ? 0 : polygons.end(polygons.size() - 1)); i++) {
                if (polygons.point(i) >= 0) {
                    used.set(polygons.point(i));
                }
            }
        }
        return used;
    }

    private void add(Group group, WorkBudget work) throws SceneFormatException {
        Triangulation triangulation = new Triangulation(points, group.polygons(),
                polygon -> "line " + group.lines().get(polygon), work, notes);
        Part part = new Part();
        IntList triangles = new IntList();
        for (int polygon = 0; polygon < group.polygons().size(); polygon++) {
            triangles.cut(0);
            triangulation.cut(polygon, triangles);
            for (int i = 0; i < triangles.size(); i += 3) {
                part.add(group, polygon, new int[] {triangles.get(i), triangles.get(i + 1), triangles.get(i + 2)});
            }
        }
        part.finish(group);
    }

    /** Collects the triangles of a group. */
    private final class Part {

        private final FloatList used = new FloatList();
        private final IntList usedPoints = new IntList();
        private final IntList corners = new IntList();
        private final IntList surfacesOf = new IntList();
        private final FloatList coordinates = new FloatList();
        private final FloatList colours = new FloatList();
        private final Map<Integer, Integer> numbers = new HashMap<>();
        private final IntList scenes = new IntList();
        /** Per corner: its number among the corners of the group's polygons. */
        private final IntList given = new IntList();
        /** Per triangle. */
        private final IntList polygons = new IntList();

        void add(Group group, int polygon, int[] three) {
            int surface = surface(group.polygons().tag(polygon));
            Integer number = numbers.get(surface);
            if (number == null) {
                number = scenes.size();
                numbers.put(surface, number);
                scenes.add(surface);
            }
            surfacesOf.add(number);
            polygons.add(polygon);
            for (int corner : three) {
                corners.add(point(group.polygons().point(corner)));
                given.add(corner);
            }
            if (textured) {
                addCoordinates(group, surface, three);
            }
            if (!file.colours.isEmpty()) {
                for (int corner : three) {
                    addColour(surface, group.polygons().point(corner));
                }
            }
        }

        /** Adds the reflectance at a vertex / that of its surface; an image of the surface has the vertex's colour. */
        private void addColour(int surface, int vertex) {
            Surface of = surfaces.get(surface);
            boolean hasImage = of.textures().stream().anyMatch(m -> m.target() == ImageMap.Target.REFLECTANCE);
            boolean hasColour = file.colours.has(vertex);
            Rgb reflectance = materials.reflectance(materialOf.get(surface), hasImage, hasColour);
            if (hasColour && !hasImage) {
                reflectance = reflectance.times(file.colours.of(vertex, options.srgb()));
            }
            if (!hasImage && reflectance.max() > Surface.MAX_REFLECTANCE && !clipped.get(surface)) {
                clipped.set(surface);
                materials.tellClipped(of.name());
            }
            for (int k = 0; k < 3; k++) {
                double whole = of.reflectance().channel(k);
                colours.add(whole > 0 && !hasImage ? (float) Math.min(1, reflectance.channel(k) / whole) : 1);
            }
        }

        private int point(int vertex) {
            if (local[vertex] < 0) {
                local[vertex] = usedPoints.size();
                usedPoints.add(vertex);
                for (int k = 0; k < 3; k++) {
                    used.add(points.get(3 * vertex + k));
                }
            }
            return local[vertex];
        }

        private void addCoordinates(Group group, int surface, int[] three) {
            float[] uv = new float[6];
            TextureImage image = imageOf.get(surface);
            boolean sound = image != null;
            for (int k = 0; k < 3 && sound; k++) {
                int at = 2 * group.textures().get(three[k]);
                sound = at >= 0 && at < file.textures.size();
                if (sound) {
                    uv[2 * k] = (float) (file.textures.get(at) * image.scaleU() + image.offsetU());
                    uv[2 * k + 1] = (float) (file.textures.get(at + 1) * image.scaleV() + image.offsetV());
                }
            }
            for (float coordinate : uv) {
                coordinates.add(sound ? coordinate : Float.NaN);
            }
        }

        /** Whether two corners have the same normal or, without normals, are of polygons of one smoothing group. */
        private boolean areAlike(Group group, int i, int j) {
            int n = group.normals().get(given.get(i));
            int m = group.normals().get(given.get(j));
            if (n < 0 || m < 0 || 3 * Math.max(n, m) >= file.normals.size()) {
                int smooth = group.smooth().get(polygons.get(i / 3));
                return smooth != 0 && smooth == group.smooth().get(polygons.get(j / 3));
            }
            return SmoothEdges.areEqual(normal(n), normal(m));
        }

        /** A normal of the file, brought to length 1, which OBJ does not ask for; one of length 0 as it is. */
        private Vec3 normal(int n) {
            Vec3 given = new Vec3(file.normals.get(3 * n), file.normals.get(3 * n + 1), file.normals.get(3 * n + 2));
            return given.length() > 0 ? given.unit() : given;
        }

        void finish(Group group) throws SceneFormatException {
            // Triangles added before the first surface with images have no coordinates yet: they get NaN.
            float[] uv = new float[coordinates.size() == 0 ? 0 : 2 * corners.size()];
            Arrays.fill(uv, Float.NaN);
            System.arraycopy(coordinates.toArray(), 0, uv, uv.length - coordinates.size(), coordinates.size());
            if (surfacesOf.size() > 0) {
                edges.add(used.toArray(), corners.toArray(), Arrays.stream(surfacesOf.toArray()).map(scenes::get)
                        .toArray(), (i, j) -> areAlike(group, i, j));
                draft.add(new TriangleMesh(used.toArray(), corners.toArray(), surfacesOf.toArray(), uv,
                        areWhite(colours) ? new float[0] : colours.toArray()),
                        new Placing(Affine.IDENTITY, false, origin), scenes.toArray(), group.node(), group.place());
            }
            for (int i = 0; i < usedPoints.size(); i++) {
                local[usedPoints.get(i)] = -1;
            }
        }
    }

    private static boolean areWhite(FloatList colours) {
        boolean white = true;
        for (int i = 0; i < colours.size() && white; i++) {
            white = colours.get(i) == 1;
        }
        return white;
    }

    /** Index in {@code surfaces} of the surface of a material, which is made when it is first used. */
    private int surface(int material) {
        Integer known = surfaceOf.get(material);
        if (known == null) {
            boolean isColoured = !file.colours.isEmpty();
            Material described = materials.material(file.materials.get(material), isColoured);
            Surface surface = materials.surface(described, isColoured);
            materialOf.add(described);
            known = surfaces.size();
            surfaceOf.put(material, known);
            surfaces.add(surface);
            imageOf.add(surface.textures().isEmpty() ? null
                    : surface.textures().get(0).target() == ImageMap.Target.REFLECTANCE ? described.diffuseImage
                    : described.emittedImage);
            textured |= !surface.textures().isEmpty();
        }
        return known;
    }
}
