package radiosity.rmi;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.ObjectStreamConstants;
import java.lang.reflect.Proxy;
import java.nio.charset.StandardCharsets;
import java.rmi.server.RemoteObjectInvocationHandler;
import java.util.Arrays;

/**
 * A stub whose host name can be replaced by the name that the user has typed. The name in the stub is the host's own
 * and need not lead there: Debian's default resolves to 127.0.1.1, and a machine may have several names.
 *
 * <p>Works on the serialized form that {@link java.rmi.server.RemoteObject} documents: a block with "UnicastRef", host,
 * port, and the object's number. An object that is exported with a filter has "UnicastRef2" and, in front of the host,
 * a 0, which means that no socket factory follows.
 */
public final class HostStub {

    private static final String PLAIN = "UnicastRef";
    private static final String WITH_FACTORY = "UnicastRef2";
    /** The beginning of both names, which follows the two bytes of their length. */
    private static final byte[] KIND = PLAIN.getBytes(StandardCharsets.US_ASCII);
    /** Largest number of bytes of a block: its length is one unsigned byte. */
    private static final int LONGEST_BLOCK = 255;

    /** Bytes in front of the block, and behind it. */
    private final byte[] before;
    private final byte[] after;
    private final String host;
    private final int port;
    /** The rest of the block: the object's number. */
    private final byte[] object;

    private HostStub(byte[] before, byte[] after, String host, int port, byte[] object) {
        this.before = before;
        this.after = after;
        this.host = host;
        this.port = port;
        this.object = object;
    }

    /** @throws IOException where the handler's serialized form is another */
    public static HostStub of(RemoteObjectInvocationHandler handler) throws IOException {
        byte[] bytes = serialized(handler);
        int block = block(bytes);
        int end = block + (bytes[block - 1] & LONGEST_BLOCK);
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(bytes, block, end - block));
        if (in.readUTF().equals(WITH_FACTORY) && in.readByte() != 0) {
            throw wrongKind();
        }
        String host = in.readUTF();
        int port = in.readInt();
        return new HostStub(Arrays.copyOf(bytes, block - 2), Arrays.copyOfRange(bytes, end, bytes.length), host, port,
                in.readAllBytes());
    }

    /** The partition of which this is the handler. */
    public static RemotePartition partition(RemoteObjectInvocationHandler handler) {
        return (RemotePartition) Proxy.newProxyInstance(RemotePartition.class.getClassLoader(),
                new Class<?>[] {RemotePartition.class}, handler);
    }

    private static byte[] serialized(Object stub) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
            out.writeObject(stub);
        }
        return bytes.toByteArray();
    }

    private static int block(byte[] bytes) throws IOException {
        for (int i = 4; i + KIND.length < bytes.length; i++) {
            if (bytes[i - 4] == ObjectStreamConstants.TC_BLOCKDATA
                    && Arrays.equals(bytes, i, i + KIND.length, KIND, 0, KIND.length)) {
                return i - 2;
            }
        }
        throw wrongKind();
    }

    private static IOException wrongKind() {
        return new IOException("stub: expected one of a plain remote object, got another kind");
    }

    public int port() {
        return port;
    }

    public HostStub at(String otherHost) {
        return new HostStub(before, after, otherHost, port, object);
    }

    public RemoteObjectInvocationHandler handler() throws IOException {
        ByteArrayOutputStream block = new ByteArrayOutputStream();
        DataOutputStream out = new DataOutputStream(block);
        out.writeUTF(PLAIN);
        out.writeUTF(host);
        out.writeInt(port);
        out.write(object);
        if (block.size() > LONGEST_BLOCK) {
            throw new IOException("host: expected a shorter name, got " + host);
        }
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        all.write(before);
        all.write(ObjectStreamConstants.TC_BLOCKDATA);
        all.write(block.size());
        all.write(block.toByteArray());
        all.write(after);
        try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(all.toByteArray()))) {
            return (RemoteObjectInvocationHandler) in.readObject();
        } catch (ClassNotFoundException e) {
            throw new IOException(e);
        }
    }
}
