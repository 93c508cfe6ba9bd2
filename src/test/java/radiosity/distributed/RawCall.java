package radiosity.distributed;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.rmi.Remote;
import java.rmi.registry.LocateRegistry;
import java.rmi.server.RemoteObjectInvocationHandler;
import java.security.MessageDigest;
import radiosity.rmi.RemotePartition;

/** A remote call whose arguments need not be what the method takes: a caller with other classes could make it. */
final class RawCall {

    private final RemoteObjectInvocationHandler handler;
    private final RemotePartition stub;

    RawCall(int port) throws Exception {
        handler = (RemoteObjectInvocationHandler) LocateRegistry.getRegistry("localhost", port).lookup("Partition");
        stub = (RemotePartition) Proxy.newProxyInstance(RemotePartition.class.getClassLoader(),
                new Class<?>[] {RemotePartition.class}, handler);
    }

    RemotePartition honest() {
        return stub;
    }

    /** Calls {@code send(long, byte[])} with another object in the place of the bytes. */
    void send(Object instead) throws Exception {
        Method send = RemotePartition.class.getMethod("send", long.class, byte[].class);
        handler.getRef().invoke((Remote) stub, send, new Object[] {1L, instead}, hash("send(J[B)V"));
    }

    /** As the RMI specification, section 8.3, has it. */
    private static long hash(String signature) throws Exception {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        new DataOutputStream(bytes).writeUTF(signature);
        byte[] digest = MessageDigest.getInstance("SHA").digest(bytes.toByteArray());
        long hash = 0;
        for (int i = 0; i < Long.BYTES; i++) {
            hash += (digest[i] & 0xFFL) << 8 * i;
        }
        return hash;
    }
}
