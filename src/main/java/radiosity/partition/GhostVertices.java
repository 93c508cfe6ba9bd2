package radiosity.partition;

import java.io.DataInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.BitSet;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import radiosity.mesh.RadiosityNodes;
import radiosity.protocol.Wire;
import radiosity.util.ArraySize;
import radiosity.util.EdgeKey;
import radiosity.util.Hash;

/**
 * The vertices that a host shares with other hosts: at each vertex one host gathers, and the other hosts receive the
 * irradiance as a ghost value before they use their elements.
 *
 * <p>A host that receives no ghost values gathers at these vertices itself, so only the time depends on ghost values.
 * For an agreement every host {@linkplain #name names} the vertices on its border, and the master gives each a role.
 */
public final class GhostVertices {

    /** What a host does at a vertex that it has named. */
    public enum Role {
        /** The host gathers for itself: no other host has the vertex. */
        ALONE,
        /** The host gathers for itself and for other hosts. */
        GIVES,
        /** The host receives ghost values: another host gathers. */
        TAKES
    }

    private final RadiosityNodes nodes;
    /** The vertices named for the next agreement, ascending; empty once it is made. */
    private int[] named = {};
    /** Number of the agreement between hosts; 0 where hosts have not agreed. */
    private int agreement;
    /** The vertices at which this host gathers for other hosts too, and those at which another host gathers. */
    private final BitSet given = new BitSet();
    private final BitSet taken = new BitSet();

    GhostVertices(RadiosityNodes nodes) {
        this.nodes = nodes;
    }

    /**
     * Names the vertices on the border of this host's elements, and ends the agreement.
     *
     * @return keys, 8 bytes each, that are equal on all hosts for the same vertex
     */
    public byte[] name() {
        agreement = 0;
        given.clear();
        taken.clear();
        long[] edges = edges();
        Arrays.sort(edges);
        named = EdgeKey.ends(EdgeKey.occurring(edges, elements -> elements == 1));
        ByteBuffer keys = ByteBuffer.allocate(ArraySize.of("bytes of the keys of ghost vertices", Long.BYTES,
                named.length));
        IntStream.of(named).forEach(v -> keys.putLong(keyWithLight(nodes, v)));
        return keys.array();
    }

    /**
     * Key equal on all hosts for vertices that gather the same: those of one {@link #key}, of the same light, and as
     * bright, on which the number of rays depends. Two vertices of one key, made between other ends, may differ in
     * either.
     */
    static long keyWithLight(RadiosityNodes nodes, int v) {
        long key = Hash.mix(key(nodes, v), nodes.points().bright(v));
        for (int i = nodes.channels() * v; i < nodes.channels() * (v + 1); i++) {
            key = Hash.mix(key, Double.doubleToLongBits(nodes.light().irradiance()[i]));
        }
        return key;
    }

    /** Key equal on all hosts for vertices with the same position, plane and creating split. */
    public static long key(RadiosityNodes nodes, int v) {
        long key = Hash.mix(nodes.points().key(v), nodes.points().made(v));
        key = Hash.mix(key, nodes.points().plane(v));
        for (int a = 0; a < 3; a++) {
            key = Hash.mix(key, Float.floatToIntBits(nodes.points().receivers()[3 * v + a]));
        }
        return key;
    }

    /** The edges of all elements, one key of two vertices each. */
    private long[] edges() {
        long[] edges = new long[ArraySize.of("edges of elements", 3, nodes.elements())];
        int count = 0;
        for (int node = 0; node < nodes.nodes(); node++) {
            for (int k = 0; k < 3 && nodes.isElement(node); k++) {
                edges[count++] = EdgeKey.of(nodes.corner(node, k), nodes.corner(node, (k + 1) % 3));
            }
        }
        return edges;
    }

    /** @param roles number of the agreement, then one byte per named vertex: ordinal of this host's {@link Role} */
    public void agree(DataInputStream roles) throws IOException {
        agreement = roles.readInt();
        byte[] role = Wire.exactly(roles, named.length);
        for (int i = 0; i < role.length; i++) {
            given.set(named[i], role[i] == Role.GIVES.ordinal());
            taken.set(named[i], role[i] == Role.TAKES.ordinal());
        }
        named = new int[0];
    }

    /** Whether this host gathers at some vertices for other hosts, or other hosts gather for this one. */
    boolean isShared() {
        return !given.isEmpty() || isTaking();
    }

    /** Whether other hosts gather at some vertices for this one. */
    public boolean isTaking() {
        return !taken.isEmpty();
    }

    /** Those of the given vertices at which this host gathers for other hosts too. */
    int[] given(int[] vertices) {
        return filter(vertices, given::get);
    }

    /** Those of the given vertices that this host shares with no other host. */
    int[] alone(int[] vertices) {
        return filter(vertices, v -> !given.get(v) && !taken.get(v));
    }

    /** Those of the given vertices at which this host gathers, for itself or for others. */
    int[] own(int[] vertices) {
        return filter(vertices, v -> !taken.get(v));
    }

    /** Those of the given vertices at which another host gathers. */
    int[] taken(int[] vertices) {
        return filter(vertices, taken::get);
    }

    private static int[] filter(int[] vertices, IntPredicate wanted) {
        return IntStream.of(vertices).filter(wanted).toArray();
    }

    private int bytesPerVertex() {
        return Double.BYTES * nodes.channels();
    }

    /** Ghost values for other hosts: number of the agreement, then per given vertex one double per channel, W/m². */
    public byte[] give() {
        ByteBuffer bytes = ByteBuffer.allocate(ArraySize.of("bytes of ghost values",
                Integer.BYTES + (long) bytesPerVertex() * given.cardinality())).putInt(agreement);
        double[] irradiance = nodes.light().irradiance();
        for (int v = given.nextSetBit(0); v >= 0; v = given.nextSetBit(v + 1)) {
            for (int c = 0; c < nodes.channels(); c++) {
                bytes.putDouble(irradiance[nodes.channels() * v + c]);
            }
        }
        return bytes.array();
    }

    /**
     * Takes ghost values from other hosts.
     *
     * @param values number of the agreement, then per taken vertex its irradiance, one double per channel, W/m²
     * @return whether the values belong to the present agreement; if not, no irradiance is changed
     * @throws IOException where there are fewer values than taken vertices
     */
    boolean take(DataInputStream values) throws IOException {
        if (values.readInt() != agreement) {
            return false;
        }
        ByteBuffer bytes = ByteBuffer.wrap(Wire.exactly(values, (long) bytesPerVertex() * taken.cardinality()));
        for (int v = taken.nextSetBit(0); v >= 0; v = taken.nextSetBit(v + 1)) {
            for (int c = 0; c < nodes.channels(); c++) {
                nodes.light().irradiance()[nodes.channels() * v + c] = bytes.getDouble();
            }
        }
        return true;
    }
}
