package radiosity.gltf;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import radiosity.scene.Affine;
import radiosity.scene.Camera;
import radiosity.scene.Rgb;
import radiosity.scene.Vec3;

/**
 * The lists of a glTF file that is being written, whose members refer to each other by index.
 *
 * @param root of the file's JSON; a list is added to the root when its first member is added
 */
public record GltfLists(ObjectNode root) {

    /** Component types of accessors. */
    public static final int FLOAT = 5126;
    public static final int UNSIGNED_INT = 5125;
    public static final int UNSIGNED_SHORT = 5123;
    /** Targets of buffer views. */
    public static final int VERTICES = 34962;
    public static final int INDICES = 34963;
    /** Filters of samplers. */
    public static final int NEAREST = 9728;
    public static final int LINEAR = 9729;
    /** How samplers go on beyond the edges of an image. */
    public static final int CLAMP = 33071;
    public static final int MIRROR = 33648;
    public static final int REPEAT = 10497;

    /**
     * Bytes of an element of an accessor, with the bytes that align the columns of a matrix; 0 for a type or component
     * type that glTF does not have.
     */
    public static int elementSize(String type, int componentType) {
        int bytes = componentSize(componentType);
        return switch (type) {
            case "SCALAR" -> bytes;
            case "VEC2" -> 2 * bytes;
            case "VEC3" -> 3 * bytes;
            case "VEC4" -> 4 * bytes;
            case "MAT2" -> 2 * Glb.padded(2 * bytes);
            case "MAT3" -> 3 * Glb.padded(3 * bytes);
            case "MAT4" -> 4 * Glb.padded(4 * bytes);
            default -> 0;
        };
    }

    /** Bytes of a component of an element of an accessor; 0 for a component type that glTF does not have. */
    public static int componentSize(int componentType) {
        return switch (componentType) {
            case 5120, 5121 -> 1;
            case 5122, UNSIGNED_SHORT -> 2;
            case UNSIGNED_INT, FLOAT -> 4;
            default -> 0;
        };
    }

    /** A list, which is created if there is none yet. */
    public ArrayNode list(String name) {
        return root.withArrayProperty(name);
    }

    /** The index of the last member of a list. */
    public int last(String name) {
        return list(name).size() - 1;
    }

    public ObjectNode get(String name, int place) {
        return (ObjectNode) list(name).get(place);
    }

    /**
     * Adds an accessor of a whole buffer view and returns its index.
     *
     * @param target of the view, {@link #VERTICES} or {@link #INDICES}
     * @param count  number of elements
     */
    public int accessor(int view, int target, int componentType, int count, String type) {
        get("bufferViews", view).put("target", target);
        list("accessors").addObject().put("bufferView", view).put("componentType", componentType).put("count", count)
                .put("type", type);
        return last("accessors");
    }

    /**
     * Sets minimum and maximum of an accessor of three components.
     *
     * @param values 3 per element, at least one element; not modified
     */
    public void range(int accessor, float[] values) {
        ArrayNode min = get("accessors", accessor).putArray("min");
        ArrayNode max = get("accessors", accessor).putArray("max");
        for (int c = 0; c < 3; c++) {
            float low = values[c];
            float high = values[c];
            for (int i = c; i < values.length; i += 3) {
                low = Math.min(low, values[i]);
                high = Math.max(high, values[i]);
            }
            min.add((double) low);
            max.add((double) high);
        }
    }

    /**
     * Adds a camera, and gives a node the camera's name, position and rotation.
     *
     * @param at   position of the camera in the space of the node's parent
     * @param near distance of the near plane, scene units, above 0
     */
    public void camera(ObjectNode node, Camera camera, Vec3 at, double near) {
        list("cameras").addObject().put("type", "perspective").putObject("perspective")
                .put("yfov", 2 * camera.verticalHalfAngle()).put("aspectRatio", camera.aspect()).put("znear", near);
        node.put("name", "camera").put("camera", last("cameras"));
        Arrays.stream(CameraPose.quaternion(camera)).forEach(node.putArray("rotation")::add);
        put(node.putArray("translation"), at);
    }

    /** Sets the matrix of a node, column by column. */
    public static void matrix(ObjectNode node, Affine placement) {
        ArrayNode matrix = node.putArray("matrix");
        for (int i = 0; i < 16; i++) {
            matrix.add(i % 4 == 3 ? (i == 15 ? 1.0 : 0.0) : placement.m()[4 * (i % 4) + i / 4]);
        }
    }

    public static void put(ArrayNode array, Vec3 v) {
        array.add(v.x()).add(v.y()).add(v.z());
    }

    public static ArrayNode put(ArrayNode array, Rgb v) {
        return array.add(v.r()).add(v.g()).add(v.b());
    }
}
