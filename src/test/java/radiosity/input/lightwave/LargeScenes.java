package radiosity.input.lightwave;

import static radiosity.input.lightwave.Iff.chunk;
import static radiosity.input.lightwave.Iff.form;
import static radiosity.input.lightwave.Iff.s0;
import static radiosity.input.lightwave.Iff.text;
import static radiosity.input.lightwave.Iff.u2;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;

/** Writes large but sound scenes. */
final class LargeScenes {

    private LargeScenes() {
    }

    /** A scene of one object, a square of n x n smaller squares with heights. */
    static Path terrain(Path folder, int n) throws IOException {
        ByteBuffer points = ByteBuffer.allocate(12 * (n + 1) * (n + 1));
        ByteBuffer polygons = ByteBuffer.allocate(18 * n * n);
        for (int i = 0; i <= n; i++) {
            for (int j = 0; j <= n; j++) {
                points.putFloat(i).putFloat((float) Math.sin(0.1 * i * j)).putFloat(j);
            }
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                int p = i * (n + 1) + j;
                polygons.putShort((short) 4);
                for (int q : new int[] {p, p + 1, p + n + 2, p + n + 1}) {
                    polygons.putInt(0xFF000000 | q);
                }
            }
        }
        Files.write(folder.resolve("terrain.lwo"), form("LWO2", chunk("TAGS", s0("white")),
                chunk("PNTS", points.array()), chunk("POLS", text("FACE"), polygons.array()),
                chunk("PTAG", text("SURF"), u2(0, 0)), Objects.lwo2Surface("white", "")));
        return Files.writeString(folder.resolve("terrain.lws"), "LWSC\n3\nLoadObjectLayer 1 terrain.lwo\n");
    }

    /** A scene that loads one square many times, each with its own motion. */
    static Path instances(Path folder, int n) throws IOException {
        Files.write(folder.resolve("square.lwo"), Objects.square());
        StringBuilder scene = new StringBuilder("LWSC\n1\n\n");
        for (int i = 0; i < n; i++) {
            scene.append("LoadObject square.lwo\nObjectMotion (unnamed)\n  9\n  1\n  ").append(i)
                    .append(" 0 0 30 0 0 1 1 1\n  0 0 0 0 0\nEndBehavior 1\n").append(i > 0 ? "ParentObject 1\n" : "");
        }
        return Files.writeString(folder.resolve("instances.lws"), scene);
    }
}
