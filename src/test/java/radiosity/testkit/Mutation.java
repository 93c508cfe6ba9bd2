package radiosity.testkit;

import java.io.ByteArrayOutputStream;
import java.util.Arrays;
import java.util.Random;

/** Changes a few things in a file, as bad disks and worse people do. */
public final class Mutation {

    private static final int[] BAD_BYTES = {0, 1, 0x7F, 0x80, 0xFE, 0xFF, ' ', '\n', '{', '}', '-', '9', '.'};

    private Mutation() {
    }

    /** @param sound not modified */
    public static byte[] of(byte[] sound, Random random) {
        byte[] mutant = sound.clone();
        for (int n = 1 + random.nextInt(6); n > 0 && mutant.length > 8; n--) {
            mutant = once(mutant, random);
        }
        return mutant;
    }

    private static byte[] once(byte[] bytes, Random random) {
        int at = random.nextInt(bytes.length);
        int length = 1 + random.nextInt(Math.min(64, bytes.length));
        switch (random.nextInt(7)) {
            case 0 -> bytes[at] ^= (byte) (1 << random.nextInt(8));
            case 1 -> bytes[at] = (byte) BAD_BYTES[random.nextInt(BAD_BYTES.length)];
            case 2 -> Arrays.fill(bytes, at, Math.min(bytes.length, at + 4), (byte) (random.nextBoolean() ? 0xFF : 0));
            case 3 -> {
                return Arrays.copyOf(bytes, at);
            }
            case 4 -> {
                return join(Arrays.copyOf(bytes, at), Arrays.copyOfRange(bytes, Math.min(bytes.length, at + length),
                        bytes.length));
            }
            case 5 -> {
                byte[] piece = Arrays.copyOfRange(bytes, at, Math.min(bytes.length, at + length));
                return join(Arrays.copyOf(bytes, at), piece, Arrays.copyOfRange(bytes, at, bytes.length));
            }
            default -> {
                int from = random.nextInt(bytes.length);
                System.arraycopy(bytes.clone(), from, bytes, at, Math.min(length, bytes.length - Math.max(at, from)));
            }
        }
        return bytes;
    }

    private static byte[] join(byte[]... parts) {
        ByteArrayOutputStream joined = new ByteArrayOutputStream();
        for (byte[] part : parts) {
            joined.writeBytes(part);
        }
        return joined.toByteArray();
    }
}
