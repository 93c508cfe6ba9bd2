package radiosity.gltf;

/** The container of a glTF binary: a header, a chunk of JSON, a chunk of arrays (glTF 2.0, section 4). */
public final class Glb {

    public static final int MAGIC = 0x46546C67;
    public static final int VERSION = 2;
    /** Types of chunks. */
    public static final int JSON = 0x4E4F534A;
    public static final int BIN = 0x004E4942;
    /** Bytes of the header of a file, and of that of a chunk. */
    public static final int HEAD = 12;
    public static final int CHUNK_HEAD = 8;

    private Glb() { }

    /** The least multiple of 4 that is not below a number of bytes. */
    public static int padded(int bytes) {
        return bytes + 3 & ~3;
    }

    /** The least multiple of 4 that is not below a number of bytes. */
    public static long padded(long bytes) {
        return bytes + 3 & ~3L;
    }
}
