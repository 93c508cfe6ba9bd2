package radiosity.input.file;

import java.nio.charset.StandardCharsets;

/** Says what a file is that is no LightWave object or scene, for messages. */
public final class FileSniffer {

    private static final int[] APPLE_DOUBLE = {0x00, 0x05, 0x16, 0x07};
    private static final int SHOWN = 12;

    private FileSniffer() {
    }

    public static String describe(byte[] bytes) {
        String start = new String(bytes, 0, Math.min(bytes.length, 64), StandardCharsets.ISO_8859_1);
        if (bytes.length == 0) {
            return "an empty file";
        }
        if (start.startsWith("version https://git-lfs")) {
            return "a Git LFS pointer: the file itself was not fetched";
        }
        if (isAppleDouble(bytes)) {
            return "an AppleDouble file (._name), which holds a Mac's file attributes only";
        }
        if (start.startsWith("FORM") && start.contains("\u00EF\u00BF\u00BD")) {
            return "a file spoilt by a conversion of its text encoding";
        }
        if (start.startsWith("FORM") && bytes.length < 12) {
            return "an IFF file of " + bytes.length + " bytes";
        }
        if (start.startsWith("FORM")) {
            return "an IFF file of type " + start.substring(8, 12);
        }
        return "a file that begins with \"" + start.substring(0, Math.min(SHOWN, start.length())) + "\"";
    }

    private static boolean isAppleDouble(byte[] bytes) {
        for (int i = 0; i < APPLE_DOUBLE.length; i++) {
            if (bytes.length <= i || bytes[i] != APPLE_DOUBLE[i]) {
                return false;
            }
        }
        return true;
    }
}
