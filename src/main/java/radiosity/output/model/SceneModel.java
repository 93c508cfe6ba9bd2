package radiosity.output.model;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;
import radiosity.gltf.GltfLists;
import radiosity.gltf.GltfModel;
import radiosity.output.image.Picture;
import radiosity.output.image.PictureFormat;
import radiosity.scene.Affine;
import radiosity.scene.Hierarchy;
import radiosity.scene.ImageMap;
import radiosity.scene.Raster;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneNode;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.util.Aabb;

/**
 * Makes a glTF model of a scene from another format: original triangles under the scene's nodes, surfaces as materials.
 */
public final class SceneModel {

    /** Distance of the camera's near plane, of the square root of the scene's area. */
    private static final double NEAR = 1e-3;
    /** A mesh is far from the origin of its node if its middle is farther than this many diagonals of its box. */
    private static final double FAR = 16;
    private static final String STRENGTH = "KHR_materials_emissive_strength";

    private final Scene scene;
    private final GltfModel model = new GltfModel(JsonNodeFactory.instance.objectNode(), new ArrayList<>());
    private final ObjectNode json = model.json();
    private final Map<Integer, Integer> materials = new HashMap<>();
    /** 1 per node of the hierarchy: the map from the node's space to the scene's; the identity if it has no inverse. */
    private final List<Affine> worlds = new ArrayList<>();

    private SceneModel(Scene scene) {
        this.scene = scene;
    }

    public static GltfModel of(Scene scene) throws IOException {
        return new SceneModel(scene).made();
    }

    private GltfModel made() throws IOException {
        json.putObject("asset").put("version", "2.0").put("generator", "radiosity");
        json.put("scene", 0);
        ArrayNode top = json.putArray("scenes").addObject().put("name", scene.name()).putArray("nodes");
        ArrayNode nodes = json.putArray("nodes");
        Hierarchy hierarchy = scene.hierarchy().written();
        for (SceneNode node : hierarchy.nodes()) {
            Affine parent = node.parent() < 0 ? Affine.IDENTITY : worlds.get(node.parent());
            Affine world = parent.times(node.placement());
            boolean usable = world.isFinite() && world.determinant() != 0;
            (!usable || node.parent() < 0 ? top
                    : ((ObjectNode) nodes.get(node.parent())).withArrayProperty("children")).add(nodes.size());
            ObjectNode own = nodes.addObject().put("name", node.name());
            worlds.add(usable ? world : Affine.IDENTITY);
            if (usable && !Arrays.equals(node.placement().m(), Affine.IDENTITY.m())) {
                GltfLists.matrix(own, node.placement());
            }
        }
        Map<Integer, Map<Integer, List<Integer>>> bySurface = new TreeMap<>();
        for (int t = 0; t < scene.triangles(); t++) {
            bySurface.computeIfAbsent(hierarchy.of(t), n -> new TreeMap<>())
                    .computeIfAbsent(scene.surfaceOf()[t], s -> new ArrayList<>()).add(t);
        }
        for (Map.Entry<Integer, Map<Integer, List<Integer>>> object : bySurface.entrySet()) {
            int number = object.getKey();
            if (number < 0) {
                top.add(nodes.size());
                number = nodes.size();
                nodes.addObject().put("name", scene.name());
            }
            mesh(number, object.getKey() < 0 ? Affine.IDENTITY : worlds.get(number), object.getValue());
        }
        scene.camera().ifPresent(camera -> {
            top.add(nodes.size());
            model.lists().camera(nodes.addObject(), camera, camera.position(), NEAR * Math.sqrt(scene.area()));
        });
        return model;
    }

    private void mesh(int node, Affine world, Map<Integer, List<Integer>> bySurface) throws IOException {
        Vec3 origin = origin(world, bySurface.values());
        Affine placement = world.times(Affine.move(origin.x(), origin.y(), origin.z()));
        int holder = origin.length() == 0 ? node : moved(node, origin);
        ObjectNode own = (ObjectNode) json.get("nodes").get(holder);
        ArrayNode meshes = json.withArrayProperty("meshes");
        own.put("mesh", meshes.size());
        ArrayNode primitives = meshes.addObject().put("name", own.get("name").asText()).putArray("primitives");
        for (Map.Entry<Integer, List<Integer>> part : bySurface.entrySet()) {
            int[] triangles = part.getValue().stream().mapToInt(t -> t).toArray();
            int[] vertices = new int[3 * triangles.length];
            for (int i = 0; i < vertices.length; i++) {
                vertices[i] = i;
            }
            boolean reversed = world.determinant() < 0;
            model.places().add(new GltfModel.Place(holder, primitives.size(), Optional.empty(), vertices, triangles,
                    reversed));
            primitive(primitives.addObject(), placement, part.getKey(), triangles, reversed);
        }
    }

    /**
     * The middle of a mesh in its node's space where the mesh is far from the origin there, so that floats would lose
     * its shape; else zero.
     */
    private Vec3 origin(Affine world, Collection<List<Integer>> parts) {
        Aabb box = Aabb.of(parts.stream().flatMap(List::stream).flatMap(t -> IntStream.range(0, 3).mapToObj(k ->
                local(world, scene.corner(t, k)))));
        Vec3 middle = box.low().plus(box.high()).times(0.5);
        boolean isFar = middle.length() > FAR * box.diagonal();
        return isFar ? new Vec3((float) middle.x(), (float) middle.y(), (float) middle.z()) : Vec3.ZERO;
    }

    /** Adds a node below another, moved by a vector, and returns the new node's number. */
    private int moved(int node, Vec3 by) {
        ArrayNode nodes = (ArrayNode) json.get("nodes");
        ObjectNode parent = (ObjectNode) nodes.get(node);
        parent.withArrayProperty("children").add(nodes.size());
        GltfLists.put(nodes.addObject().put("name", parent.get("name").asText()).putArray("translation"), by);
        return nodes.size() - 1;
    }

    /** A point of the scene in the space of a node. */
    private static Vec3 local(Affine world, Vec3 p) {
        double[] local = world.unturn(new double[] {p.x() - world.m()[3], p.y() - world.m()[7],
            p.z() - world.m()[11]});
        return new Vec3(local[0], local[1], local[2]);
    }

    private void primitive(ObjectNode primitive, Affine world, int surface, int[] triangles, boolean reversed)
            throws IOException {
        float[] points = new float[9 * triangles.length];
        float[] coordinates = new float[6 * triangles.length];
        float[] colours = new float[9 * triangles.length];
        boolean coloured = false;
        boolean mapped = false;
        for (int i = 0; i < 3 * triangles.length; i++) {
            int t = triangles[i / 3];
            int k = reversed ? (3 - i % 3) % 3 : i % 3;
            Vec3 p = scene.corner(t, k);
            Vec3 local = local(world, p);
            for (int a = 0; a < 3; a++) {
                points[3 * i + a] = (float) local.coordinate(a);
                colours[3 * i + a] = (float) scene.vertexColour(t, k).channel(a);
            }
            coloured |= scene.isColoured(t);
            if (scene.hasImages(t)) {
                mapped = true;
                coordinates[2 * i] = scene.textureCoordinates()[6 * t + 2 * k];
                coordinates[2 * i + 1] = 1 - scene.textureCoordinates()[6 * t + 2 * k + 1];
            }
        }
        ObjectNode attributes = primitive.putObject("attributes");
        int positions = model.accessor(points, 3);
        model.lists().range(positions, points);
        attributes.put("POSITION", positions);
        if (mapped) {
            attributes.put("TEXCOORD_0", model.accessor(coordinates, 2));
        }
        if (coloured) {
            attributes.put("COLOR_0", model.accessor(colours, 3));
        }
        primitive.put("material", material(surface));
    }

    private int material(int number) throws IOException {
        Integer known = materials.get(number);
        if (known != null) {
            return known;
        }
        Surface surface = scene.surfaces().get(number);
        ArrayNode list = json.withArrayProperty("materials");
        ObjectNode material = list.addObject().put("name", surface.name()).put("doubleSided", surface.twoSided());
        ObjectNode base = material.putObject("pbrMetallicRoughness").put("metallicFactor", 0).put("roughnessFactor", 1);
        Optional<Raster> reflectance = surface.maps().reflectance();
        if (reflectance.isPresent()) {
            base.putObject("baseColorTexture").put("index", texture(reflectance.get(), 1));
        } else {
            GltfLists.put(base.putArray("baseColorFactor"), surface.reflectance()).add(1.0);
        }
        if (surface.emits()) {
            emission(material, surface);
        }
        materials.put(number, list.size() - 1);
        return list.size() - 1;
    }

    /** Writes emission, which glTF has in cd/m² in a photometric scene. */
    private void emission(ObjectNode material, Surface surface) throws IOException {
        Optional<Raster> map = surface.maps().exitance();
        double perExitance = scene.units().luminancePerRadiosity();
        double most = perExitance * (map.isPresent() ? picture(map.get()).most() : surface.exitance().max());
        double strength = Math.max(1, most);
        if (strength > 1) {
            material.putObject("extensions").putObject(STRENGTH).put("emissiveStrength", strength);
            if (!json.path("extensionsUsed").toString().contains(STRENGTH)) {
                json.withArrayProperty("extensionsUsed").add(STRENGTH);
            }
        }
        if (map.isPresent()) {
            material.putObject("emissiveTexture").put("index", texture(map.get(), perExitance / strength));
            GltfLists.put(material.putArray("emissiveFactor"), Rgb.grey(1));
        } else {
            GltfLists.put(material.putArray("emissiveFactor"), surface.exitance().times(perExitance / strength));
        }
    }

    /** Adds a texture, the raster's light times a factor, and returns its number. */
    private int texture(Raster raster, double factor) throws IOException {
        byte[] png = PictureFormat.png(picture(raster), light -> light.times(factor));
        ArrayNode images = json.withArrayProperty("images");
        images.addObject().put("mimeType", "image/png").put("bufferView", model.add(png));
        ArrayNode samplers = json.withArrayProperty("samplers");
        samplers.addObject().put("wrapS", wrap(raster.wrapU())).put("wrapT", wrap(raster.wrapV()));
        ArrayNode textures = json.withArrayProperty("textures");
        textures.addObject().put("sampler", samplers.size() - 1).put("source", images.size() - 1);
        return textures.size() - 1;
    }

    private static Picture picture(Raster raster) {
        return new Picture(raster.width(), raster.height(), raster.rgb());
    }

    private static int wrap(ImageMap.Wrap wrap) {
        return switch (wrap) {
            case REPEAT -> GltfLists.REPEAT;
            case MIRROR -> GltfLists.MIRROR;
            case NONE, EDGE -> GltfLists.CLAMP;
        };
    }
}
