package radiosity.rmi;

import java.io.ObjectInputFilter;
import java.util.Set;

/**
 * What may come in by deserialization. Without filters a method that takes bytes only can be sent any object, which is
 * made before the call is refused.
 */
public final class SerialFilters {

    private static final int DEPTH = 2;
    private static final int REFERENCES = 8;
    private static final int STREAM_BYTES = 4096;
    /** What fits into an answer of a sound host: blocks of a message share the memory with the world itself. */
    private static final long MOST_BYTES = Math.max(16L << 20, Runtime.getRuntime().maxMemory() / 8);

    /** What the JDK's own side of a call brings along. */
    private static final Set<String> OF_RMI = Set.of("java.rmi.server.RemoteObjectInvocationHandler",
            "java.rmi.server.RemoteObject", "java.rmi.server.RemoteStub", "java.rmi.server.UID",
            "java.rmi.server.ObjID", "java.rmi.dgc.VMID", "java.rmi.dgc.Lease", "sun.rmi.server.UnicastRef",
            "sun.rmi.registry.RegistryImpl_Stub", "java.rmi.registry.Registry", "java.rmi.Remote");
    private static final Set<String> PLAIN = Set.of("java.lang.String", "java.lang.Number", "java.lang.Integer",
            "java.lang.Long", "java.lang.Boolean", "java.lang.StackTraceElement", "java.lang.Enum",
            "java.util.Collections$EmptyList", "java.util.Collections$UnmodifiableList",
            "java.util.Collections$UnmodifiableCollection", "java.util.ArrayList", "java.lang.Object",
            SessionEndedException.class.getName());
    private static final int DEPTH_OF_ERRORS = 20;
    private static final int REFERENCES_OF_ERRORS = 10_000;

    private SerialFilters() { }

    /** On what a host exports: bytes, and nothing else. */
    public static ObjectInputFilter.Status ofHost(ObjectInputFilter.FilterInfo info) {
        if (info.depth() > DEPTH || info.references() > REFERENCES || info.arrayLength() > MOST_BYTES
                || info.streamBytes() > MOST_BYTES + STREAM_BYTES) {
            return ObjectInputFilter.Status.REJECTED;
        }
        Class<?> type = info.serialClass();
        return type == null ? ObjectInputFilter.Status.UNDECIDED
                : type == byte[].class ? ObjectInputFilter.Status.ALLOWED : ObjectInputFilter.Status.REJECTED;
    }

    /** In the master, for all of the process: a host is not trusted either. */
    public static synchronized void ofMaster() {
        if (ObjectInputFilter.Config.getSerialFilter() == null) {
            ObjectInputFilter.Config.setSerialFilter(SerialFilters::check);
        }
    }

    static ObjectInputFilter.Status check(ObjectInputFilter.FilterInfo info) {
        if (info.depth() > DEPTH_OF_ERRORS || info.references() > REFERENCES_OF_ERRORS
                || info.arrayLength() > MOST_BYTES) {
            return ObjectInputFilter.Status.REJECTED;
        }
        Class<?> type = info.serialClass();
        while (type != null && type.isArray()) {
            type = type.getComponentType();
        }
        return type == null || type.isPrimitive() || known(type) ? ObjectInputFilter.Status.ALLOWED
                : ObjectInputFilter.Status.REJECTED;
    }

    private static boolean known(Class<?> type) {
        boolean ofJdk = type.getName().startsWith("java.");
        return PLAIN.contains(type.getName()) || OF_RMI.contains(type.getName())
                || ofJdk && Throwable.class.isAssignableFrom(type);
    }
}
