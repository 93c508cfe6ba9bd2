package radiosity.input.lightwave;

import static radiosity.input.lightwave.HostileCase.EITHER;
import static radiosity.input.lightwave.HostileCase.ERROR;
import static radiosity.input.lightwave.HostileCase.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Scenes that are broken, made to break readers, or made to read what they should not. */
final class HostileScenes {

    private static final String ROOM = "LoadObject room.lwo\n";
    private static final String V1 = "LWSC\n1\n\n" + ROOM;
    private static final String V5 = "LWSC\n5\n\nLoadObjectLayer 1 10000000 room.lwo\n";

    private HostileScenes() {
    }

    static List<HostileCase> all() {
        List<HostileCase> all = new ArrayList<>();
        all.addAll(heads());
        all.addAll(paths());
        all.addAll(parents());
        all.addAll(motions());
        all.addAll(blocks());
        return all;
    }

    private static List<HostileCase> heads() {
        return List.of(
                scene("empty scene", "", ERROR, "an empty file"),
                scene("no version", "LWSC\n", ERROR, "version number"),
                scene("version 0", "LWSC\n0\n" + ROOM, ERROR, "version number"),
                scene("version 99", "LWSC\n99\nLoadObjectLayer 1 10000000 room.lwo\n", 2, "read as version 5"),
                scene("version that is none", "LWSC\nabc\n" + ROOM, ERROR, "version number"),
                scene("version of 30 digits", "LWSC\n" + "9".repeat(30) + "\n" + ROOM, ERROR, "version number"),
                scene("lines with CR", V1.replace('\n', '\r'), 2, ""),
                scene("lines with CR LF", V1.replace("\n", "\r\n"), 2, ""),
                scene("byte order mark", "\u00EF\u00BB\u00BF" + V1, 2, ""),
                scene("Ctrl-Z at the end", V1 + "\u001a", 2, ""),
                scene("zero bytes", V1.replace("\n", "\u0000\n") + "\u0000\u0000", 2, ""),
                scene("without objects", "LWSC\n1\n", ERROR, "at least one polygon"),
                scene("only null objects", "LWSC\n1\nAddNullObject a\nAddNullObject b\n", ERROR,
                        "at least one polygon"),
                scene("line of 20 MB", V1 + "Comment " + "x".repeat(20_000_000) + "\n" + ROOM, 4, "are cut"),
                new HostileCase("random bytes", Map.of("a.lws", random(100_000)), "a.lws", ERROR, "LightWave scene"),
                new HostileCase("random bytes after the head", Map.of("a.lws", Iff.join(Iff.text("LWSC\n1\n"),
                        random(1_000_000))), "a.lws", ERROR, "at least one polygon"),
                new HostileCase("a directory", Map.of("a.lws/b.lwo", Objects.square()), "a.lws", ERROR, "a directory"));
    }

    private static byte[] random(int n) {
        byte[] bytes = new byte[n];
        new java.util.Random(3).nextBytes(bytes);
        return bytes;
    }

    private static List<HostileCase> paths() {
        String missing = "objects that are not found";
        return List.of(
                scene("all objects missing", "LWSC\n1\nLoadObject a.lwo\nLoadObject b.lwo\n", ERROR,
                        "at least one polygon"),
                scene("one object missing", V1 + "LoadObject gone.lwo\n", 2, missing),
                scene("20,000 objects missing", manyMissing(20_000), 2, missing),
                scene("no path at all", V1 + "LoadObject\nLoadObject \n", 2, missing),
                scene("upwards out of the content", V1 + "LoadObject ../../../../../../etc/passwd\n", 2, missing),
                scene("absolute", V1 + "LoadObject /etc/passwd\n", 2, missing),
                scene("device", V1 + "LoadObject /dev/zero\nLoadObject CON\nLoadObject NUL:\n", 2, missing),
                scene("UNC", V1 + "LoadObject \\\\server\\share\\thing.lwo\n", 2, missing),
                scene("URL", V1 + "LoadObject http://example.org/thing.lwo\n", 2, missing),
                scene("drive letter", V1 + "LoadObject C:\\NewTek\\Objects\\ROOM.LWO\n", 4, ""),
                scene("Amiga volume", V1 + "LoadObject Work:Objects/Room\n", 4, ""),
                scene("8.3 name", V1 + "LoadObject D:\\ROO~1.LWO\n", 4, ""),
                new HostileCase("blanks in a path", Map.of("my objects/the room.lwo", Objects.square(), "a.lws",
                        Iff.text("LWSC\n1\nLoadObject my objects/the room.lwo   \n")), "a.lws", 2, ""),
                scene("zero byte in a path", V1 + "LoadObject ro\u0000om.lwo\n", 2, missing),
                scene("path of 4,000 characters", V1 + "LoadObject " + "d/".repeat(2000) + "x.lwo\n", 2, missing),
                scene("path of control characters", V1 + "LoadObject x\u001b[31m\u0007\u009b.lwo\n", 2, "\\u001b"),
                scene("scene that loads itself", V1 + "LoadObject a.lws\n", 2, missing),
                new HostileCase("scenes that load one another", Map.of("room.lwo", Objects.square(), "a.lws",
                        Iff.text(V1 + "LoadObject b.lws\n"), "b.lws", Iff.text(V1 + "LoadObject a.lws\n")), "a.lws", 2,
                        missing),
                new HostileCase("object that is text", Map.of("room.lwo", Objects.square(), "b.lwo", Iff.text("hello"),
                        "a.lws", Iff.text(V1 + "LoadObject b.lwo\n")), "a.lws", 2, missing),
                new HostileCase("Mac's attributes beside", Map.of("._room.lwo", Iff.text("FORM"), "x/room.lwo",
                        Objects.square(), "a.lws", Iff.text("LWSC\n1\nLoadObject Disk:room.lwo\n")), "a.lws", 2, ""));
    }

    private static String manyMissing(int n) {
        StringBuilder text = new StringBuilder(V1);
        for (int i = 0; i < n; i++) {
            text.append("LoadObject C:\\objects\\gone").append(i).append(".lwo\nLoadObject here/gone").append(i)
                    .append('\n');
        }
        return text.toString();
    }

    private static List<HostileCase> parents() {
        String missing = "item that does not exist";
        return List.of(
                scene("parent is itself", V1 + "ParentObject 1\n", 2, "circle"),
                scene("parents in a circle", V1 + "ParentObject 2\n" + ROOM + "ParentObject 1\n", 4, "circle"),
                scene("parent comes later", V1 + "ParentObject 2\n" + ROOM, 4, ""),
                scene("parent out of range", V1 + "ParentObject 999\n", 2, missing),
                scene("parent that is no number", V1 + "ParentObject abc\n", 2, missing),
                scene("parent by a bad identity", V5 + "ParentItem zzzz\n" + "ParentItem\n", 2, missing),
                scene("parent by an identity that is not there", V5 + "ParentItem 1000ABCD\n", 2, missing),
                scene("parent of an unknown kind", V5 + "ParentItem F0000000\n", 2, missing),
                scene("parent is a bone", V5 + "LoadObjectLayer 1 10000001 room.lwo\nParentItem 40050000\n", 4, ""),
                scene("identity twice", V5 + "LoadObjectLayer 1 10000000 room.lwo\n", 4, "same identity"),
                scene("identity that is none", "LWSC\n5\nLoadObjectLayer 1 qq room.lwo\n", 2, ""),
                scene("layer that is not there", V5 + "LoadObjectLayer 7 10000001 room.lwo\n", 2, "layers that"),
                new HostileCase("30,000 layers", Map.of("room.lwo", Iff.form("LWO2", manyLayers(30_000)), "a.lws",
                        Iff.text(manyLayerLines(30_000))), "a.lws", 30_000, "does not describe"),
                scene("layer 0", "LWSC\n3\nLoadObjectLayer 0 room.lwo\n", 2, "layer's number"),
                scene("layer that is no number", "LWSC\n3\nLoadObjectLayer x room.lwo\n", 2, "layer's number"),
                scene("chain of 20,000 parents", chain(20_000), 2, ""),
                scene("chain of 20,000 parents that come later", backwardChain(20_000), 2, ""),
                scene("50,000 instances", "LWSC\n1\n" + ROOM.repeat(50_000), 100_000, ""));
    }

    private static byte[] manyLayers(int n) {
        byte[][] layers = new byte[n][];
        for (int i = 0; i < n; i++) {
            layers[i] = Iff.join(Objects.layer(i, 0), Iff.chunk("PNTS", Iff.f4(0, i, 0, 0, i, 1, 1, i, 0)),
                    Iff.chunk("POLS", Iff.text("FACE"), Iff.u2(3, 0, 1, 2)));
        }
        return Iff.join(layers);
    }

    private static String manyLayerLines(int n) {
        StringBuilder text = new StringBuilder("LWSC\n3\n");
        for (int i = 1; i <= n; i++) {
            text.append("LoadObjectLayer ").append(i).append(" room.lwo\n");
        }
        return text.toString();
    }

    private static String chain(int n) {
        StringBuilder text = new StringBuilder("LWSC\n1\n");
        for (int i = 0; i < n; i++) {
            text.append("AddNullObject n\nParentObject ").append(i).append('\n');
        }
        return text.append(ROOM).append("ParentObject ").append(n).append('\n').toString();
    }

    private static String backwardChain(int n) {
        StringBuilder text = new StringBuilder(V1).append("ParentObject 2\n");
        for (int i = 2; i <= n; i++) {
            text.append("AddNullObject n\nParentObject ").append(i + 1).append('\n');
        }
        return text.append("AddNullObject last\n").toString();
    }

    private static List<HostileCase> motions() {
        return List.of(
                scene("999,999,999 keys", V1 + motion1("999999999", "0 0 0 0 0 0 1 1 1"), 2, ""),
                scene("1.#IND", V1 + motion1("1", "1.#IND 1.#INF -1.#IND 0 0 0 1 1 nan"), 2, "keys without numbers"),
                scene("decimal comma", V1 + motion1("1", "1,5 0 0 0 0 0 1 1 1"), 2, ""),
                scene("scale zero", V1 + motion1("1", "0 0 0 0 0 0 0 0 0") + ROOM, 2, "without area"),
                scene("scale negative", V1 + motion1("1", "0 0 0 0 0 0 -1 1 1"), 2, ""),
                scene("numbers beyond all", V1 + motion1("1", "1e308 1e308 0 0 0 0 1e308 1e300 1e300") + ROOM, 2,
                        "too large"),
                scene("2,000,000,000 frames", "LWSC\n1\nFirstFrame 2000000000\nLastFrame 2000000000\n" + ROOM
                        + "ObjectMotion (unnamed)\n9\n2\n0 0 0 0 0 0 1 1 1\n0 0 0 0 0\n1 0 0 0 0 0 1 1 1\n1 0 0 0 0\n"
                        + "EndBehavior 2\n", 2, ""),
                scene("no frames per second", "LWSC\n3\nFramesPerSecond 0\nLoadObjectLayer 1 room.lwo\n", 2, ""),
                scene("motion without end", V1 + "ObjectMotion (unnamed)\n9\n1\n0 0 0 0 0 0 1 1 1\n0 0 0 0 0\n" + ROOM,
                        4,
                        "no EndBehavior"),
                scene("motion at the end of the file", V1 + "ObjectMotion (unnamed)", 2, ""),
                scene("counts at the end of the file", V1 + "ObjectMotion (unnamed)\n9", 2, "no EndBehavior"),
                scene("channel out of range", V5 + "ObjectMotion\nNumChannels 9\nChannel 99999999999\n{ Envelope\n  1\n"
                        + "  Key 1 0 0 0 0 0 0 0 0\n}\nChannel -5\n{ Envelope\n 1\n Key 1 0 0\n}\n", 2, ""),
                scene("keys at one time", V5 + "ObjectMotion\nNumChannels 9\nChannel 0\n{ Envelope\n  3\n"
                        + "  Key 1 0 0 0 0 0\n  Key 2 0 0 0 0 0\n  Key 3 0 5 0 0 0\n  Behaviors 2 3\n}\n", 2, ""),
                scene("negative camera zoom", V1 + "ShowCamera 1 7\nZoomFactor -3\n", 2, "camera"),
                scene("light of an unknown kind", V1 + "AddLight\nLgtIntensity 1\nLightType 77\n", 2, "not known"));
    }

    private static String motion1(String keys, String values) {
        return "ObjectMotion (unnamed)\n  9\n  " + keys + "\n  " + values + "\n  0 0 0 0 0\nEndBehavior 1\n";
    }

    private static List<HostileCase> blocks() {
        return List.of(
                scene("200,000 nested braces", V5 + "Thing\n" + "{ a\n".repeat(200_000) + "}\n".repeat(200_000)
                        + "LoadObjectLayer 1 10000001 room.lwo\n", 4, ""),
                scene("200,000 braces that do not close", V5 + "{ a\n".repeat(200_000), 2, "no closing brace"),
                scene("200,000 closing braces", V5 + "}\n".repeat(200_000), 2, ""),
                scene("envelope that does not close", V5 + "ObjectMotion\nNumChannels 9\nChannel 0\n{ Envelope\n 1\n"
                        + " Key 0 0 0\nLoadObjectLayer 1 10000001 room.lwo\n", 4, "no closing brace"),
                scene("plug-in text with keywords", V5
                        + "Plugin ItemHandler 1 x\nLoadObjectLayer 1 10000009 gone.lwo\n{\n{\n"
                        + "ParentItem 10000000\nEndPlugin\n", 2, ""),
                scene("plug-in without end", V5 + "Plugin ItemHandler 1 x\nLoadObjectLayer 1 10000001 room.lwo\n", 4,
                        "no end"),
                scene("100,000 plug-ins without end", V5 + "Plugin ItemHandler 1 x\n".repeat(100_000), 2, "no end"),
                scene("a camera between all objects", "LWSC\n1\n" + (ROOM + "ZoomFactor 3\n").repeat(20_000), 40_000,
                        ""),
                scene("20,000 cameras and targets", V5 + "AddCamera\nTargetItem 10000000\n".repeat(20_000), EITHER,
                        ""));
    }
}
