package radiosity.input.lightwave;

import static radiosity.input.lightwave.HostileCase.ERROR;
import static radiosity.input.lightwave.HostileCase.object;
import static radiosity.input.lightwave.Iff.chunk;
import static radiosity.input.lightwave.Iff.f4;
import static radiosity.input.lightwave.Iff.form;
import static radiosity.input.lightwave.Iff.join;
import static radiosity.input.lightwave.Iff.s0;
import static radiosity.input.lightwave.Iff.sub;
import static radiosity.input.lightwave.Iff.text;
import static radiosity.input.lightwave.Iff.u2;

import java.io.ByteArrayOutputStream;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;

/** Files of 15 MB of the smallest thing of a kind: what costs few bytes in a file must not cost many in memory. */
public final class BulkFiles {

    private static final int SIZE = 15_000_000;

    private BulkFiles() {
    }

    public static List<HostileCase> all() {
        return List.of(
                object("tags", form("LWO2", chunk("TAGS", new byte[SIZE])), ERROR, ""),
                object("polygons", form("LWO2", chunk("POLS", text("FACE"), new byte[SIZE])), ERROR, ""),
                object("oldPolygons", form("LWOB", chunk("POLS", new byte[SIZE])), ERROR, ""),
                object("points", form("LWOB", chunk("PNTS", new byte[SIZE])), ERROR, ""),
                object("layers", form("LWO2", fill(i -> Objects.layer(i & 0xFFFF, 0))), ERROR, ""),
                object("surfaces", form("LWO2", fill(i -> Objects.lwo2Surface("s" + i, ""))), ERROR, ""),
                object("clips", form("LWO2", fill(i -> chunk("CLIP", Iff.u4(i), sub("STIL", s0("a"))))), ERROR, ""),
                object("maps", form("LWO2", fill(i -> chunk("VMAP", text("TXUV"), u2(2), s0("m"), u2(0), f4(0, 0)))),
                        ERROR, ""),
                object("textures", form("LWO2",
                        Objects.lwo2Surface("s", "", fill(i -> sub("BLOK", sub("IMAP", s0("a")))))),
                        ERROR, ""),
                object("tags of polygons", form("LWO2", chunk("POLS", text("FACE"), u2(0)),
                        chunk("PTAG", text("SURF"), new byte[SIZE])), ERROR, ""),
                scene("objects", "LoadObject a\n"),
                scene("plugIns", "Plugin a\n"),
                scene("keys", "ObjectMotion\n{ E\nKey 1\nKey 1\nKey 1\nKey 1\nKey 1\nKey 1\nKey 1\nKey 1\n"),
                scene("envelopes", "ObjectMotion\n{\n}\n"));
    }

    private static byte[] fill(IntFunction<byte[]> thing) {
        ByteArrayOutputStream all = new ByteArrayOutputStream(SIZE + 100);
        for (int i = 0; all.size() < SIZE; i++) {
            all.writeBytes(thing.apply(i));
        }
        return all.toByteArray();
    }

    private static HostileCase scene(String name, String line) {
        byte[] all = join(text("LWSC\n3\nAddNullObject x\n"), fill(i -> text(line)));
        return new HostileCase(name, Map.of("a.lws", all), "a.lws", ERROR, "");
    }
}
