package radiosity.input.lightwave.lws;

import java.util.Set;
import radiosity.input.file.Diagnostics;
import radiosity.input.file.FileSniffer;
import radiosity.scene.SceneFormatException;

/** Reads the text of a scene file (LWSC 1 to 5): one method per kind of line. Unknown keywords are skipped. */
public final class SceneParser {

    private static final Set<String> KEPT = Set.of("ParentObject", "ParentItem", "PivotPoint", "PivotPosition",
            "PivotRotation", "ObjDissolve", "ObjectDissolve", "TargetObject", "TargetItem",
            "LightName", "LightColor", "LgtIntensity", "LightIntensity", "LightType", "ConeAngle", "EdgeAngle",
            "LightConeAngle", "LightEdgeAngle", "LightRange",
            "ZoomFactor", "FrameSize", "CustomSize", "PixelAspect", "PixelAspectRatio", "CustomPixelRatio");
    private static final Set<String> GLOBALS = Set.of("FirstFrame", "FramesPerSecond", "CurrentCamera");
    private static final Set<String> MOVED_BY_PLUGINS = Set.of("ItemMotionHandler", "DisplacementHandler",
            "ObjReplacementHandler", "ChannelHandler");

    /** Most items: the JVM's heap limit divided by a kilobyte per item. */
    private static final long MOST_ITEMS = Runtime.getRuntime().maxMemory() >> 10;

    private final SceneLines lines;
    private final Diagnostics notes;
    private final MotionParser motions;
    private final SceneDescription scene;
    private SceneItem item;
    /** The latest object and camera: their own lines may also follow after lines of other items, bones for example. */
    private SceneItem object;
    private SceneItem camera;
    private boolean pluginsEnd = true;

    private SceneParser(SceneLines lines, SceneDescription scene, Diagnostics notes) {
        this.lines = lines;
        this.scene = scene;
        this.notes = notes;
        this.motions = new MotionParser(lines, scene.version, notes);
    }

    /** Whether the bytes begin as a scene does. */
    public static boolean isScene(byte[] file) {
        SceneLines lines = new SceneLines(file, new Diagnostics("", w -> { }, false));
        return lines.next() && lines.keyword().equals("LWSC");
    }

    public static SceneDescription parse(byte[] file, Diagnostics notes) throws SceneFormatException {
        SceneLines lines = new SceneLines(file, notes);
        if (!lines.next() || !lines.keyword().equals("LWSC")) {
            throw notes.error("line 1", "LWSC", FileSniffer.describe(file));
        }
        SceneDescription scene = new SceneDescription(version(lines, notes));
        new SceneParser(lines, scene, notes).parse();
        return scene;
    }

    private static int version(SceneLines lines, Diagnostics notes) throws SceneFormatException {
        String text = lines.value();
        if (text.isEmpty() && lines.next()) {
            text = lines.line();
        }
        long version = SceneNumbers.whole(text, 10);
        if (version < 1 || version > 99) {
            throw notes.error(lines.place(), "a version number from 1 to 5", text);
        }
        if (version > 5) {
            notes.note(lines.place(), "a version that is not known is read as version 5", text);
        }
        return (int) version;
    }

    private void parse() throws SceneFormatException {
        while (lines.next()) {
            if (scene.items.size() > MOST_ITEMS) {
                throw notes.error(lines.place(), "at most " + MOST_ITEMS + " objects, lights and cameras", "more");
            }
            line(lines.keyword(), lines.value());
        }
    }

    private void line(String keyword, String value) {
        switch (keyword) {
            case "LoadObject" -> loadObject(value);
            case "LoadObjectLayer" -> loadLayer(value);
            case "AddNullObject" -> addNull(value);
            case "AddLight" -> begin(SceneItem.Kind.LIGHT, identity(value));
            case "AddCamera" -> begin(SceneItem.Kind.CAMERA, identity(value));
            case "AddBone" -> addBone(value);
            case "ObjectMotion", "LightMotion", "CameraMotion", "BoneMotion" -> motion(keyword);
            case "Plugin" -> plugin(value);
            case "HController", "PController", "BController" -> controller(value);
            case "MorphTarget", "MTSEMorphing" -> notes.note(lines.place(), "morphs are not evaluated");
            case "DisplacementMap" -> notes.note(lines.place(), "displacement maps are not evaluated");
            default -> other(keyword, value);
        }
    }

    private void other(String keyword, String value) {
        if (keyword.startsWith("{")) {
            lines.back();
            motions.skipBlock();
        } else if (GLOBALS.contains(keyword)) {
            scene.put(keyword, SceneNumbers.one(value));
        } else if (KEPT.contains(keyword)) {
            keep(keyword, value);
        }
    }

    private void keep(String keyword, String value) {
        SceneItem owner = isOfCamera(keyword) ? camera() : keyword.startsWith("Obj") ? object : item;
        if (value.equals("(envelope)")) {
            Motion envelope = motions.read();
            if (owner != null) {
                owner.put(keyword, envelope);
            }
        } else if (owner != null) {
            owner.put(keyword, value);
        }
    }

    private static boolean isOfCamera(String keyword) {
        return keyword.startsWith("Zoom") || keyword.startsWith("Frame") || keyword.startsWith("Custom")
                || keyword.startsWith("Pixel");
    }

    private SceneItem begin(SceneItem.Kind kind, long id) {
        item = new SceneItem(kind, id, lines.number());
        scene.items.add(item);
        camera = kind == SceneItem.Kind.CAMERA ? item : camera;
        object = kind == SceneItem.Kind.OBJECT ? item : object;
        return item;
    }

    private void loadObject(String path) {
        begin(SceneItem.Kind.OBJECT, -1).file = path;
    }

    /** Reads the layer's number (from 1), the identity (version 4 and later) and the path, which may contain blanks. */
    private void loadLayer(String value) {
        String rest = SceneLines.afterWord(value);
        long layer = SceneNumbers.whole(SceneLines.firstWord(value), 10);
        long id = -1;
        if (scene.version >= SceneDescription.WITH_IDENTITIES) {
            id = SceneNumbers.whole(SceneLines.firstWord(rest), 16);
            rest = SceneLines.afterWord(rest);
        }
        SceneItem object = begin(SceneItem.Kind.OBJECT, id);
        object.file = rest;
        object.layer = (int) Math.max(0, Math.min(Integer.MAX_VALUE, layer - 1));
        if (layer < 1) {
            notes.note(lines.place(), "a layer's number is none, the first layer is taken", value);
        }
    }

    /** Reads the name of a null object, which may contain blanks; in version 4 and later its identity stands before. */
    private void addNull(String value) {
        boolean identified = scene.version >= SceneDescription.WITH_IDENTITIES;
        begin(SceneItem.Kind.OBJECT, identity(SceneLines.firstWord(value))).nullName =
                identified ? SceneLines.afterWord(value) : value;
    }

    private void addBone(String value) {
        notes.note(lines.place(), "bones do not bend objects here");
        begin(SceneItem.Kind.BONE, identity(value));
    }

    private long identity(String value) {
        return scene.version >= SceneDescription.WITH_IDENTITIES ? SceneNumbers.whole(value, 16) : -1;
    }

    /** The camera to which camera keywords belong; added here in version 1, whose camera has no AddCamera line. */
    private SceneItem camera() {
        if (item == null || item.kind != SceneItem.Kind.CAMERA) {
            item = camera == null ? begin(SceneItem.Kind.CAMERA, -1) : camera;
        }
        return item;
    }

    private void motion(String keyword) {
        SceneItem owner = keyword.equals("CameraMotion") ? camera() : item;
        Motion motion = motions.read();
        if (owner != null) {
            owner.motion = motion;
        }
    }

    private void controller(String value) {
        if (SceneNumbers.one(value) >= 3) {
            notes.note(lines.place(), "inverse kinematics are not evaluated");
        }
    }

    /** Skips a plug-in's text up to EndPlugin, but takes the kind of a light from its first line (version 5). */
    private void plugin(String value) {
        String[] words = value.split("\\s+", 3);
        if (words[0].equals("LightHandler") && words.length == 3 && item != null) {
            item.put("LightHandler", words[2]);
        }
        if (MOVED_BY_PLUGINS.contains(words[0])) {
            notes.note(lines.place(), "plug-ins that move or bend items are not evaluated", value);
        }
        long body = lines.mark();
        while (pluginsEnd && lines.next()) {
            if (lines.keyword().equals("EndPlugin")) {
                return;
            }
        }
        pluginsEnd = false;
        lines.returnTo(body);
        notes.note(lines.place(), "a plug-in has no end");
    }
}
