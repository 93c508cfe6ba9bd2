package radiosity.input.obj;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import radiosity.input.assembly.SceneDraft;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.DoubleList;
import radiosity.input.file.FloatList;
import radiosity.scene.Affine;
import radiosity.scene.SceneFormatException;
import radiosity.scene.SceneNode;
import radiosity.settings.ReadOptions;

/** Reads the text of an OBJ file: vertices, texture vertices, and polygons by object, group and material. */
final class ObjParser {

    /** Name of the material of polygons before the first material. */
    static final String NO_MATERIAL = "default";

    private static final int MOST_MATERIALS = 1 << 16;
    private static final int MOST_LIBRARIES = 1000;
    /** Index of a missing vertex, above those of all files. */
    private static final int MISSING = Integer.MAX_VALUE / 4;
    private static final Set<String> CURVED = Set.of("curv", "curv2", "surf", "cstype", "vp", "deg", "bmat", "parm");

    final DoubleList points = new DoubleList();
    final FloatList textures = new FloatList();
    final FloatList normals = new FloatList();
    final VertexColours colours = new VertexColours();
    /** In the order of the file. */
    final List<Group> groups = new ArrayList<>();
    /** Names of materials, by the polygons' tags. */
    final List<String> materials = new ArrayList<>();
    /** Texts after "mtllib" as written; each names one library or several. */
    final Set<String> libraries = new LinkedHashSet<>();

    private final String name;
    private final ReadOptions.Up up;
    private final SceneDraft draft;
    private final Diagnostics notes;
    private final TextLines lines;
    private final Map<String, Integer> materialNumbers = new LinkedHashMap<>();
    private final Map<String, Integer> objects = new LinkedHashMap<>();
    private final Map<List<String>, Group> byName = new LinkedHashMap<>();
    private String object = "";
    private String group = "";
    /** Polygons of the current object and group; null before the first polygon. */
    private Group present;
    private int material = -1;
    private int smooth;

    /** @param name name of the object for polygons before any object and group */
    ObjParser(byte[] file, String name, ReadOptions.Up up, SceneDraft draft, Diagnostics notes) {
        this.up = up;
        this.name = name;
        this.draft = draft;
        this.notes = notes;
        lines = new TextLines(file);
    }

    void parse() throws SceneFormatException {
        while (lines.next()) {
            String keyword = lines.word();
            switch (keyword) {
                case "v" -> vertex();
                case "vt" -> texture();
                case "vn" -> normal();
                case "s" -> smooth = (int) TextLines.number(lines.word(), 0);
                case "f", "fo" -> face();
                case "o" -> begin(lines.rest(), "");
                case "g" -> begin(object, lines.rest());
                case "usemtl" -> material = material(lines.rest());
                case "mtllib" -> library(lines.rest());
                default -> {
                    if (CURVED.contains(keyword)) {
                        notes.note(lines.place(), "curves and free-form surfaces are left out", keyword);
                    }
                }
            }
        }
    }

    private void library(String names) throws SceneFormatException {
        if (libraries.size() >= MOST_LIBRARIES) {
            throw notes.error(lines.place(), "at most " + MOST_LIBRARIES + " material libraries", "more");
        }
        libraries.add(names);
    }

    private void vertex() {
        int vertex = points.size() / 3;
        for (double x : three()) {
            points.add(x);
        }
        double[] more = new double[4];
        int size = 0;
        for (String word = lines.word(); !word.isEmpty() && size < more.length; word = lines.word()) {
            more[size++] = TextLines.number(word, Double.NaN);
        }
        // a fourth number alone is a weight, and so is one before a colour
        if (size == 2 || size > 2 && !colours.add(vertex, more, size)) {
            notes.note(lines.place(), "colours of vertices that are not three numbers of at least 0 are left out");
        }
    }

    private void texture() {
        textures.add((float) lines.number("missing"));
        textures.add((float) lines.number("0"));
    }

    private void normal() {
        for (double x : three()) {
            normals.add((float) x);
        }
    }

    /** The next three numbers of the line, as a place or direction with y up. */
    private double[] three() {
        double x = lines.number("missing");
        double y = lines.number("missing");
        double z = lines.number("missing");
        return up == ReadOptions.Up.Y ? new double[] {x, y, z} : new double[] {x, z, 0 - y};
    }

    private void begin(String newObject, String newGroup) {
        object = newObject;
        group = newGroup;
        present = null;
    }

    private int material(String called) throws SceneFormatException {
        Integer number = materialNumbers.get(called);
        if (number == null) {
            if (materials.size() >= MOST_MATERIALS) {
                throw notes.error(lines.place(), "at most " + MOST_MATERIALS + " materials", "more");
            }
            number = materials.size();
            materialNumbers.put(called, number);
            materials.add(called);
        }
        return number;
    }

    private void face() throws SceneFormatException {
        if (present == null) {
            present = group();
        }
        if (material < 0) {
            material = material(NO_MATERIAL);
        }
        int vertices = points.size() / 3;
        int textureVertices = textures.size() / 2;
        for (String word = lines.word(); !word.isEmpty(); word = lines.word()) {
            int slash = word.indexOf('/');
            int next = slash < 0 ? -1 : word.indexOf('/', slash + 1);
            String texture = slash < 0 ? "" : word.substring(slash + 1, next < 0 ? word.length() : next);
            int point = index(slash < 0 ? word : word.substring(0, slash), vertices);
            int at = texture.isEmpty() ? MISSING : index(texture, textureVertices);
            present.polygons().corner(point);
            present.textures().add(at == MISSING ? -1 : at);
            int normal = next < 0 ? MISSING : index(word.substring(next + 1), normals.size() / 3);
            present.normals().add(normal == MISSING ? -1 : normal);
        }
        present.polygons().close(material);
        present.smooth().add(smooth);
        present.lines().add(lines.number());
    }

    /**
     * Index from a number that counts from 1, or back from the latest vertex if negative; vertices may follow later.
     */
    private static int index(String text, int count) {
        double number = TextLines.number(text, 0);
        double index = number < 0 ? count + number : number - 1;
        return index >= 0 && index < MISSING && index == Math.rint(index) ? (int) index : MISSING;
    }

    /** The current object and group with its own node, which is a child of the object's node where both have names. */
    private Group group() throws SceneFormatException {
        Group known = byName.get(List.of(object, group));
        if (known == null) {
            int node = object.isEmpty() && !group.isEmpty() ? node(group, -1)
                    : group.isEmpty() ? object() : node(group, object());
            known = new Group(node, lines.place());
            byName.put(List.of(object, group), known);
            groups.add(known);
        }
        return known;
    }

    private int object() throws SceneFormatException {
        Integer known = objects.get(object);
        if (known == null) {
            known = node(object.isEmpty() ? name : object, -1);
            objects.put(object, known);
        }
        return known;
    }

    private int node(String called, int parent) throws SceneFormatException {
        return draft.node(new SceneNode(called, parent, called, Affine.IDENTITY), lines.place());
    }
}
