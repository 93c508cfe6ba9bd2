package radiosity.input.lightwave;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import radiosity.input.assembly.TriangleMesh;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FloatList;
import radiosity.input.file.IntList;
import radiosity.input.file.WorkBudget;
import radiosity.input.lightwave.lwo.Layer;
import radiosity.input.lightwave.lwo.ObjectModel;
import radiosity.input.lightwave.lwo.SurfaceValues;
import radiosity.input.polygon.Triangulation;

/**
 * The triangles of some layers of an object in the object's left-handed coordinates, shared by all its instances.
 *
 * @param triangles triangles, their surfaces and texture coordinates
 * @param surfaces  the surfaces that the triangles refer to, as the object describes them
 * @param pivot     x, y, z of the point about which the object turns if its scene names no pivot
 */
record ObjectMesh(TriangleMesh triangles, List<SurfaceValues> surfaces, double[] pivot) {

    /** Cuts the polygons of the layers into triangles; defects of the polygons are noted. */
    static ObjectMesh of(ObjectModel object, List<Layer> layers, WorkBudget work, Diagnostics notes) {
        Builder builder = new Builder(object, work, notes);
        layers.forEach(builder::add);
        double[] pivot = layers.size() == 1 ? layers.get(0).pivot : new double[3];
        return builder.build(pivot);
    }

    /** Collects the triangles of one layer after the other. */
    private static final class Builder {

        private final ObjectModel object;
        private final WorkBudget work;
        private final Diagnostics notes;
        private final FloatList points = new FloatList();
        private final IntList corners = new IntList();
        private final IntList surfaceOf = new IntList();
        private final FloatList coordinates = new FloatList();
        private final Map<SurfaceValues, Optional<TextureMapping>> mappings = new IdentityHashMap<>();
        private final boolean textured;
        private final Map<String, Integer> surfaceIndex = new HashMap<>();
        private final List<SurfaceValues> surfaces = new ArrayList<>();

        Builder(ObjectModel object, WorkBudget work, Diagnostics notes) {
            this.object = object;
            this.work = work;
            this.notes = notes;
            this.textured = object.surfaces.values().stream().anyMatch(s -> !s.textures.isEmpty());
        }

        void add(Layer layer) {
            mappings.clear();
            Triangulation triangulation = new Triangulation(layer.points, layer.polygons,
                    polygon -> "layer " + layer.number + ", polygon " + polygon, work, notes);
            int[] newPoint = new int[layer.pointCount()];
            Arrays.fill(newPoint, -1);
            IntList triangles = new IntList();
            for (int polygon = 0; polygon < layer.polygons.size(); polygon++) {
                triangles.cut(0);
                triangulation.cut(polygon, triangles);
                if (triangles.size() > 0) {
                    addTriangles(layer, polygon, triangles, newPoint);
                }
            }
        }

        private void addTriangles(Layer layer, int polygon, IntList triangles, int[] newPoint) {
            int surface = surface(layer, polygon);
            if (textured) {
                addCoordinates(layer, polygon, triangles, surfaces.get(surface));
            }
            for (int i = 0; i < triangles.size(); i++) {
                corners.add(point(layer, layer.polygons.point(triangles.get(i)), newPoint));
                if (i % 3 == 0) {
                    surfaceOf.add(surface);
                }
            }
        }

        private void addCoordinates(Layer layer, int polygon, IntList triangles, SurfaceValues surface) {
            Optional<TextureMapping> mapping = mappings.computeIfAbsent(surface, s -> s.textures.stream().findFirst()
                    .map(t -> new TextureMapping(t, layer)));
            double[] uv = new double[6];
            for (int i = 0; i < triangles.size(); i += 3) {
                Arrays.fill(uv, Double.NaN);
                int[] three = {triangles.get(i), triangles.get(i + 1), triangles.get(i + 2)};
                mapping.ifPresent(m -> m.map(polygon, three, uv));
                for (double coordinate : uv) {
                    coordinates.add((float) coordinate);
                }
            }
        }

        private int point(Layer layer, int old, int[] newPoint) {
            if (newPoint[old] < 0) {
                newPoint[old] = points.size() / 3;
                for (int k = 0; k < 3; k++) {
                    points.add(layer.points.get(3 * old + k));
                }
            }
            return newPoint[old];
        }

        private int surface(Layer layer, int polygon) {
            int tag = layer.polygons.tag(polygon);
            String name = tag >= 0 && tag < object.tags.size() ? object.tags.get(tag) : "Default";
            if (tag >= object.tags.size()) {
                notes.note("layer " + layer.number + ", polygon " + polygon,
                        "polygons with a surface number beyond the list of names get the standard surface",
                        String.valueOf(tag));
            }
            return surfaceIndex.computeIfAbsent(name, this::newSurface);
        }

        private Integer newSurface(String name) {
            SurfaceValues described = object.surfaces.get(name);
            if (described == null) {
                notes.note("", "surfaces that the object does not describe are taken as a light grey", name);
                described = SurfaceValues.standard(name);
            }
            surfaces.add(described);
            return surfaces.size() - 1;
        }

        ObjectMesh build(double[] pivot) {
            return new ObjectMesh(new TriangleMesh(points.toArray(), corners.toArray(), surfaceOf.toArray(),
                    coordinates.toArray(), new float[0]), List.copyOf(surfaces), pivot);
        }
    }
}
