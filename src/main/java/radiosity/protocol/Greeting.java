package radiosity.protocol;

import java.io.DataInputStream;
import java.io.IOException;

/**
 * A host's description of itself.
 *
 * @param version    version of the host's program
 * @param build      digest of the program's classes, see {@code Build.id}
 * @param processors number of threads with which the host computes
 * @param busy       text that names the master that uses the host, and since when; empty where the host is free
 * @param server     number that the host has chosen at random: a host may be reached by several names
 */
public record Greeting(String version, String build, int processors, String busy, long server) {

    public byte[] encode() {
        return Wire.bytes(out -> {
            out.writeUTF(version);
            out.writeUTF(build);
            out.writeInt(processors);
            out.writeUTF(busy);
            out.writeLong(server);
        });
    }

    public static Greeting decode(byte[] bytes) throws IOException {
        DataInputStream in = Wire.input(bytes);
        return new Greeting(in.readUTF(), in.readUTF(), in.readInt(), in.readUTF(),
                in.readLong());
    }
}
