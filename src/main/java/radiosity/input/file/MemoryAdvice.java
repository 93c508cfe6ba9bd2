package radiosity.input.file;

/** Says in messages about limits that the memory sets how much memory to give. */
public final class MemoryAdvice {

    private MemoryAdvice() { }

    /**
     * The advice in words.
     *
     * @param bytes memory with which the limit would be met, as far as is known; 0 where nothing is known
     * @return a power of two, at least twice the present memory
     */
    public static String forBytes(long bytes) {
        long mebibytes = Math.max(2 * Runtime.getRuntime().maxMemory(), bytes) - 1 >> 20;
        return "give, say, JAVA_OPTS=-Xmx" + 2 * Long.highestOneBit(Math.max(1, mebibytes)) + "m";
    }
}
