package radiosity.input.file;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;

/** Describes, for messages, a file that the program cannot read: by its content, else by its name. */
public final class FileSniffer {

    /** Number of bytes at the beginning of a file that suffice to recognise the file. */
    public static final int START = 1 << 16;

    private static final int SHOWN = 12;

    /** A byte order mark of UTF-16. */
    private static final Pattern MARKED = Pattern.compile("\u00FF\u00FE|\u00FE\u00FF");
    /** Four characters of ASCII in UTF-16 without a byte order mark; no binary file that is read begins so. */
    private static final Pattern UNMARKED = Pattern.compile("([\t\n\r -~]\0){4}|(\0[\t\n\r -~]){4}");

    /** Descriptions of files by their first bytes, in ISO 8859-1. */
    private static final Map<String, String> BEGINNINGS = new LinkedHashMap<>();
    /** Descriptions of XML files by a text among their first bytes. */
    private static final Map<String, String> CONTENTS = new LinkedHashMap<>();
    /** Descriptions of files that their content does not identify, by the extension of their names. */
    private static final Map<String, String> ENDINGS = new LinkedHashMap<>();

    static {
        BEGINNINGS.put("version https://git-lfs", "a Git LFS pointer: the file itself was not fetched");
        BEGINNINGS.put("\0\5\26\7", "an AppleDouble file (._name), which holds a Mac's file attributes only");
        ENDINGS.put("obj", "an OBJ file");
        ENDINGS.put("gltf", "a glTF file that is no binary");
        BEGINNINGS.put("Kaydara FBX", "an FBX file");
        BEGINNINGS.put("; FBX", "an FBX file");
        BEGINNINGS.put("BLENDER", "a Blender file");
        BEGINNINGS.put("ply\n", "a PLY file");
        BEGINNINGS.put("ply\r", "a PLY file");
        BEGINNINGS.put("PXR-USDC", "a USD file");
        BEGINNINGS.put("#usda", "a USD file");
        BEGINNINGS.put("#VRML", "a VRML file");
        BEGINNINGS.put("3D Geometry File Format", "a Rhino file");
        BEGINNINGS.put("QC4DC4D6", "a Cinema 4D file");
        BEGINNINGS.put("ISO-10303-21", "a STEP or IFC file");
        BEGINNINGS.put("AC10", "a DWG file");
        BEGINNINGS.put("Ogawa", "an Alembic file");
        BEGINNINGS.put("xof ", "a DirectX file");
        BEGINNINGS.put("//Maya", "a Maya file");
        BEGINNINGS.put("\u00FF\u00FE\u00FF\u000ES\0k\0e\0t\0c\0h\0U\0p", "a SketchUp file");
        BEGINNINGS.put("IESNA", "an IES photometric file");
        BEGINNINGS.put("\u0089PNG", "a PNG image");
        BEGINNINGS.put("\u00FF\u00D8\u00FF", "a JPEG image");
        BEGINNINGS.put("GIF8", "a GIF image");
        BEGINNINGS.put("II*\0", "a TIFF image");
        BEGINNINGS.put("MM\0*", "a TIFF image");
        BEGINNINGS.put("#?RADIANCE", "an HDR image");
        BEGINNINGS.put("v/1\1", "an EXR image");
        BEGINNINGS.put("%PDF", "a PDF document");
        CONTENTS.put("<COLLADA", "a Collada file (DAE)");
        CONTENTS.put("<X3D", "an X3D file");
        CONTENTS.put("<scene", "a scene in XML, as of Mitsuba");
        CONTENTS.put("<?xml", "an XML file");
        ENDINGS.put("fbx", "an FBX file");
        ENDINGS.put("3ds", "a 3DS file");
        ENDINGS.put("dae", "a Collada file (DAE)");
        ENDINGS.put("blend", "a Blender file");
        ENDINGS.put("stl", "an STL file");
        ENDINGS.put("ply", "a PLY file");
        for (String usd : new String[] {"usd", "usda", "usdc", "usdz"}) {
            ENDINGS.put(usd, "a USD file");
        }
        ENDINGS.put("max", "a 3ds Max file");
        ENDINGS.put("ma", "a Maya file");
        ENDINGS.put("mb", "a Maya file");
        ENDINGS.put("c4d", "a Cinema 4D file");
        ENDINGS.put("skp", "a SketchUp file");
        ENDINGS.put("dxf", "a DXF file");
        ENDINGS.put("dwg", "a DWG file");
        ENDINGS.put("3dm", "a Rhino file");
        ENDINGS.put("3mf", "a 3MF file");
        ENDINGS.put("abc", "an Alembic file");
        ENDINGS.put("x", "a DirectX file");
        ENDINGS.put("wrl", "a VRML file");
        ENDINGS.put("x3d", "an X3D file");
        ENDINGS.put("ifc", "an IFC file");
        ENDINGS.put("step", "a STEP file");
        ENDINGS.put("stp", "a STEP file");
        ENDINGS.put("mtl", "a material library of OBJ files");
        ENDINGS.put("rad", "a Radiance scene");
        ENDINGS.put("pbrt", "a scene of pbrt");
        ENDINGS.put("ldt", "a EULUMDAT photometric file");
        ENDINGS.put("zip", "a ZIP archive");
    }

    private FileSniffer() {
    }

    /**
     * Whether a file is text in UTF-16: by its byte order mark, or by first characters that are all of ASCII.
     *
     * @param start the first {@value #START} bytes of the file, or all
     */
    public static boolean isUtf16(byte[] start) {
        String text = text(start);
        return MARKED.matcher(text).lookingAt() || UNMARKED.matcher(text).lookingAt();
    }

    /** Describes a file by its content alone; empty where the content leaves any doubt. */
    public static Optional<String> foreign(byte[] start) {
        String text = text(start);
        Optional<String> beginning = BEGINNINGS.entrySet().stream().filter(entry -> text.startsWith(entry.getKey()))
                .map(Map.Entry::getValue).findFirst();
        if (beginning.isPresent()) {
            return beginning;
        }
        if (isUtf16(start)) {
            return Optional.of("text in UTF-16");
        }
        if (text.startsWith("MM") && text.length() > 7 && (text.charAt(6) == 2 && text.charAt(7) == 0
                || text.charAt(6) == '=' && text.charAt(7) == '=')) {
            return Optional.of("a 3DS file");
        }
        if (text.startsWith("solid") && text.contains("facet")) {
            return Optional.of("an STL file");
        }
        if (text.strip().startsWith("<")) {
            return CONTENTS.entrySet().stream().filter(entry -> text.contains(entry.getKey()))
                    .map(Map.Entry::getValue).findFirst();
        }
        return text.startsWith("newmtl") || text.contains("\nnewmtl ") && !text.contains("\nv ")
                ? Optional.of(ENDINGS.get("mtl")) : Optional.empty();
    }

    /** Describes a file without a known name. */
    public static String describe(byte[] start) {
        return describe(start, "");
    }

    /**
     * Describes a file.
     *
     * @param start the first {@value #START} bytes of the file, or all
     * @param name  of the file
     */
    public static String describe(byte[] start, String name) {
        String text = text(start);
        Optional<String> foreign = foreign(start);
        if (start.length == 0) {
            return "an empty file";
        }
        if (foreign.isPresent()) {
            return foreign.get();
        }
        if (text.startsWith("FORM") && text.contains("\u00EF\u00BF\u00BD")) {
            return "a file spoilt by a conversion of its text encoding";
        }
        if (text.startsWith("FORM") && start.length < 12) {
            return "an IFF file of " + start.length + " bytes";
        }
        if (text.startsWith("LWSC")) {
            return "a LightWave scene";
        }
        if (text.startsWith("FORM") && text.startsWith("LW", 8)) {
            return "a LightWave object";
        }
        if (text.startsWith("FORM")) {
            return "an IFF file of type " + text.substring(8, 12);
        }
        String ending = ENDINGS.get(name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT));
        if (ending != null) {
            return ending;
        }
        return text.startsWith("PK\3\4") ? "a ZIP archive"
                : "a file that begins with \"" + text.substring(0, Math.min(SHOWN, text.length())) + "\"";
    }

    private static String text(byte[] start) {
        return new String(start, 0, Math.min(start.length, START), StandardCharsets.ISO_8859_1);
    }
}
