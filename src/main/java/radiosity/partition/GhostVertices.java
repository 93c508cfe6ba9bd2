package radiosity.partition;

import java.io.DataInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.BitSet;
import java.util.stream.IntStream;
import radiosity.mesh.RadiosityNodes;
import radiosity.protocol.Wire;
import radiosity.util.ArraySize;
import radiosity.util.Hash;

/**
 * Receiving points that several hosts have: one of them gathers there where no elements are divided between rounds. By
 * prediction the others are given what it has got before anybody looks at their elements; in the paper's schedule the
 * master looks at them, see {@link Seam}. A point that a split made is the same where it was made by the same split: it
 * was dark then.
 */
public final class GhostVertices {

    /** What a host has to do with one of them. */
    public enum Role { ALONE, GIVES, TAKES }

    private final RadiosityNodes nodes;
    private final PointIrradiance irradiance;
    /** Nodes and vertices that were looked at for others. */
    private int lookedAt;
    private int known;
    /** The points that were named last. */
    private int[] named = {};
    /** Of what was agreed; 0 where nothing was. */
    private int agreement;
    private int[] given = {};
    private int[] taken = {};
    private final BitSet isTaken = new BitSet();
    /** Those where others do not gather; null where they are to be found. */
    private int[] own;
    private int vertices;

    GhostVertices(RadiosityNodes nodes) {
        this.nodes = nodes;
        irradiance = new PointIrradiance(nodes);
    }

    /**
     * Names those on the border of what this host has.
     *
     * @param anew whether all, and not only those that were made since
     * @return what they are, whoever has them: 8 bytes each
     */
    byte[] name(boolean anew) {
        if (anew) {
            lookedAt = known = agreement = 0;
            given = new int[0];
            taken = new int[0];
            isTaken.clear();
            own = null;
        }
        named = IntStream.of(ends(edges())).filter(v -> v >= known).toArray();
        lookedAt = nodes.nodes();
        known = nodes.vertices();
        return keys(named);
    }

    private byte[] keys(int[] points) {
        ByteBuffer keys = ByteBuffer.allocate(ArraySize.of("bytes of the keys of points of a border", Long.BYTES,
                points.length));
        IntStream.of(points).forEach(v -> keys.putLong(key(v)));
        return keys.array();
    }

    /** Of all points, whether others have them or not. */
    public byte[] keys() {
        return keys(IntStream.range(0, nodes.vertices()).toArray());
    }

    /** The same for whoever would gather the same there. */
    private long key(int v) {
        long key = Hash.mix(nodes.vertexKey(v), nodes.made(v));
        key = Hash.mix(key, nodes.vertexPlane(v));
        for (int a = 0; a < 3; a++) {
            key = Hash.mix(key, Float.floatToIntBits(nodes.receivers()[3 * v + a]));
        }
        return key;
    }

    /** Of elements that were not looked at yet: two vertices each. */
    private long[] edges() {
        long[] edges = new long[3 * (nodes.nodes() - lookedAt)];
        int count = 0;
        for (int node = lookedAt; node < nodes.nodes(); node++) {
            for (int k = 0; k < 3 && nodes.isElement(node); k++) {
                long p = nodes.corner(node, k);
                long q = nodes.corner(node, (k + 1) % 3);
                edges[count++] = Math.min(p, q) << Integer.SIZE | Math.max(p, q);
            }
        }
        return Arrays.copyOf(edges, count);
    }

    /** The ends of those that belong to one element only. */
    private static int[] ends(long[] edges) {
        Arrays.sort(edges);
        BitSet ends = new BitSet();
        for (int i = 0, next; i < edges.length; i = next) {
            next = i + 1;
            while (next < edges.length && edges[next] == edges[i]) {
                next++;
            }
            if (next == i + 1) {
                ends.set((int) (edges[i] >> Integer.SIZE));
                ends.set((int) edges[i]);
            }
        }
        return ends.stream().toArray();
    }

    /** @param roles number of the agreement, then for each that was named what to do with it */
    public void agree(DataInputStream roles) throws IOException {
        agreement = roles.readInt();
        byte[] role = Wire.exactly(roles, named.length);
        given = IntStream.concat(IntStream.of(given), withRole(role, Role.GIVES)).toArray();
        taken = IntStream.concat(IntStream.of(taken), withRole(role, Role.TAKES)).toArray();
        IntStream.of(taken).forEach(isTaken::set);
        own = null;
        named = new int[0];
    }

    private IntStream withRole(byte[] role, Role wanted) {
        return IntStream.range(0, role.length).filter(i -> role[i] == wanted.ordinal()).map(i -> named[i]);
    }

    /** Gives what it gathers at these points, too. */
    void giveAlso(BitSet points) {
        BitSet more = (BitSet) points.clone();
        more.andNot(isTaken);
        IntStream.of(given).forEach(more::clear);
        given = IntStream.concat(IntStream.of(given), more.stream()).toArray();
    }

    byte[] givenKeys() {
        return keys(given);
    }

    /** Others gather at these points, and nowhere else. */
    public void take(BitSet points) {
        isTaken.clear();
        isTaken.or(points);
        own = null;
    }

    public PointIrradiance irradiance() {
        return irradiance;
    }

    /** Where others gather; not to be modified. */
    public BitSet taken() {
        return isTaken;
    }

    /** Whether others gather at some of them. */
    boolean isTaking() {
        return !isTaken.isEmpty();
    }

    boolean isTaken(int point) {
        return isTaken.get(point);
    }

    boolean isAgreed() {
        return agreement != 0;
    }

    /** Of all points those where this host gathers; every step of a round wants them. Not to be modified. */
    int[] own() {
        if (own == null || vertices != nodes.vertices()) {
            vertices = nodes.vertices();
            own = IntStream.range(0, vertices).filter(v -> !isTaken.get(v)).toArray();
        }
        return own;
    }

    /** Of some points those where this host gathers. */
    int[] own(int[] points) {
        return IntStream.of(points).filter(v -> !isTaken.get(v)).toArray();
    }

    /** Whether at some of these others gather. */
    boolean takesAny(int[] points) {
        return IntStream.of(points).anyMatch(isTaken::get);
    }

    /** For others: number of the agreement, then channels per point. */
    public byte[] give() {
        return irradiance.told(agreement, given);
    }

    /**
     * @param gift number of the agreement, then channels per point that is taken
     * @return whether it was of this agreement: if not, nothing is changed
     */
    boolean take(DataInputStream gift) throws IOException {
        if (gift.readInt() != agreement) {
            return false;
        }
        irradiance.put(taken, gift);
        return true;
    }
}
