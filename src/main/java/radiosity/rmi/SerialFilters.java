package radiosity.rmi;

import java.io.ObjectInputFilter;
import java.util.Set;

/**
 * Filters on the objects that are deserialized from remote calls. Without filters a caller can send any object to a
 * method that takes bytes, and the object is created before the call is refused.
 */
public final class SerialFilters {

    /** Limits of a call to a host: depth and number of objects, and bytes besides the largest array. */
    private static final int DEPTH = 2;
    private static final int REFERENCES = 8;
    /** Largest number of pieces of a message to a host: as many as an array of bytes can be cut into. */
    private static final int MOST_PIECES = 1 + Integer.MAX_VALUE / RemotePartition.MOST_PIECE_BYTES;
    private static final int STREAM_BYTES = 4096;
    /** Largest number of bytes of a message: messages share the memory with the elements of the world. */
    private static final long MOST_BYTES = Math.max(16L << 20, Runtime.getRuntime().maxMemory() / 8);

    /** Classes that the JDK itself sends in a call. */
    private static final Set<String> OF_RMI = Set.of("java.rmi.server.RemoteObjectInvocationHandler",
            "java.rmi.server.RemoteObject", "java.rmi.server.RemoteStub", "java.rmi.server.UID",
            "java.rmi.server.ObjID", "java.rmi.dgc.VMID", "java.rmi.dgc.Lease", "sun.rmi.server.UnicastRef",
            "sun.rmi.registry.RegistryImpl_Stub", "java.rmi.registry.Registry", "java.rmi.Remote");
    /** Classes in answers and in exceptions of hosts. */
    private static final Set<String> PLAIN = Set.of("java.lang.String", "java.lang.Number", "java.lang.Integer",
            "java.lang.Long", "java.lang.Boolean", "java.lang.StackTraceElement", "java.lang.Enum",
            "java.util.Collections$EmptyList", "java.util.Collections$UnmodifiableList",
            "java.util.Collections$UnmodifiableCollection", "java.util.ArrayList", "java.lang.Object",
            SessionEndedException.class.getName());
    /** Limits of an answer to the master: exceptions have causes and stack traces. */
    private static final int DEPTH_OF_ERRORS = 20;
    private static final int REFERENCES_OF_ERRORS = 10_000;

    private SerialFilters() { }

    /**
     * The filter of a host's exported partition: arrays of bytes and lists of such arrays are allowed, and nothing
     * else. The arrays are small, as anybody can announce one, whose memory is allocated, and send no more.
     */
    public static ObjectInputFilter.Status ofHost(ObjectInputFilter.FilterInfo info) {
        if (info.depth() > DEPTH || info.references() > REFERENCES + MOST_PIECES
                || info.streamBytes() > MOST_BYTES + STREAM_BYTES) {
            return ObjectInputFilter.Status.REJECTED;
        }
        Class<?> type = info.serialClass();
        if (type == null) {
            return ObjectInputFilter.Status.UNDECIDED;
        }
        boolean fits = type == byte[].class && info.arrayLength() <= RemotePartition.MOST_PIECE_BYTES
                || type == byte[][].class && info.arrayLength() <= MOST_PIECES;
        return fits ? ObjectInputFilter.Status.ALLOWED : ObjectInputFilter.Status.REJECTED;
    }

    /** Sets the master's filter for its whole process, unless there is a filter: hosts are not trusted either. */
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
