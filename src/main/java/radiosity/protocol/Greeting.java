package radiosity.protocol;

import java.io.DataInputStream;
import java.io.IOException;
import radiosity.rmi.Build;

/**
 * Who a host is.
 *
 * @param version    of its program
 * @param build      of its program, see {@link Build}
 * @param processors threads that it computes with
 * @param memory     that it may use, bytes
 * @param busy       for whom and since when it works; empty where it is free
 */
public record Greeting(String version, String build, int processors, long memory, String busy) {

    public byte[] encode() {
        return Wire.bytes(out -> {
            out.writeUTF(version);
            out.writeUTF(build);
            out.writeInt(processors);
            out.writeLong(memory);
            out.writeUTF(busy);
        });
    }

    public static Greeting decode(byte[] bytes) throws IOException {
        DataInputStream in = Wire.input(bytes);
        return new Greeting(in.readUTF(), in.readUTF(), in.readInt(), in.readLong(), in.readUTF());
    }
}
