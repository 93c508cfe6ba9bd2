package radiosity.mesh;

import java.util.Arrays;
import java.util.stream.IntStream;
import radiosity.mesh.face.NodePath;
import radiosity.util.ArraySize;
import radiosity.util.Hash;
import radiosity.util.LongIndex;

/** The vertices of some patch trees in arrays: position, receiving point and irradiance of each vertex. */
public final class ReceivingPoints {

    /** Weights of a face's corners at the centroid of the face, in units of 2^-30. */
    private static final int[] MIDDLE = {NodePath.ONE / 3, NodePath.ONE / 3, NodePath.ONE - 2 * (NodePath.ONE / 3)};

    private final Patcher patcher;
    private final int channels;
    private int count;
    /** 3 per vertex: x, y, z. */
    private float[] position = new float[3 * 64];
    /** 3 per vertex: x, y, z of the point where its light is gathered. */
    private float[] receiver = new float[3 * 64];
    /** 1 per vertex: its representative face, equal for all owners; see {@link VertexKey#face}. */
    private int[] face = new int[64];
    /** 1 per vertex: key of its place, equal for all owners; see {@link VertexKey#of}. */
    private long[] key = new long[64];
    /** 1 per vertex: number of the split that made the vertex; 0 in the initial mesh. */
    private int[] made = new int[64];
    /** 1 per vertex: whether it receives nothing, as it lies inside a solid; its elements use their other vertices. */
    private boolean[] buried = new boolean[64];
    /** 1 per vertex: see {@link #bright}. */
    private byte[] bright = new byte[64];
    /** channels per vertex: irradiance H, W/m². */
    private double[] irradiance;
    /** channels per vertex: irradiance H that is set aside while all vertices gather anew, W/m²; else null. */
    private double[] aside;
    /** Vertices of the initial mesh by key, later ones by key, number of the split and ends of the divided edge. */
    private LongIndex index = new LongIndex(256);

    ReceivingPoints(Patcher patcher) {
        this.patcher = patcher;
        channels = patcher.faces().channels();
        irradiance = new double[channels * 64];
    }

    /**
     * Finds or makes the vertex with given weights of a face's corners.
     *
     * @param w    weights of the face's corners, 3 from {@code wAt}, in units of 2^-30; not modified
     * @param at   position of the vertex, 3 from {@code from}; not modified
     * @param with 0 in the initial mesh, else number of the split: only splits with the same number share vertices
     */
    int vertex(int f, int[] w, int wAt, int depth, float[] at, int from, int with) {
        return vertex(f, w, wAt, depth, at, from, with, with);
    }

    /** Finds or makes the vertex at the centroid of a face, which receives where the patcher says. */
    int middle(int f, float[] corners) {
        float[] at = new float[3];
        for (int a = 0; a < 3; a++) {
            at[a] = (corners[a] + corners[3 + a] + corners[6 + a]) / 3;
        }
        int v = vertex(f, MIDDLE, 0, 0, at, 0, 0);
        System.arraycopy(patcher.point(f), 0, receiver, 3 * v, 3);
        return v;
    }

    /** @param shared where {@code with} is not 0: vertices of one place are the same only where this is equal */
    private int vertex(int f, int[] w, int wAt, int depth, float[] at, int from, int with, long shared) {
        long id = VertexKey.of(patcher.faces(), f, w, wAt);
        int v = index.findOrAdd(with == 0 ? id : Hash.mix(id, shared), count);
        if (v < count) {
            return v;
        }
        if (count == key.length) {
            makeRoom(ArraySize.room("light at vertices in " + channels + " channels", count + 1L,
                    count + Math.max(64L, count / 4), Math.max(3, channels)));
        }
        System.arraycopy(at, from, position, 3 * v, 3);
        patcher.pull(f, w, wAt, depth, position, receiver, 3 * v);
        face[v] = VertexKey.face(patcher.faces(), f, w, wAt);
        key[v] = id;
        made[v] = with;
        count++;
        return v;
    }

    /**
     * Finds or makes the vertex halfway between vertices u and v. A new vertex has the mean irradiance of u and v.
     * After the initial mesh only elements that have both u and v share the vertex: from other ends it would get
     * another irradiance, and which ends came first would depend on how blocks are dealt.
     */
    int between(int u, int v, int f, int[] w, int depth, int with) {
        float[] at = new float[3];
        for (int a = 0; a < 3; a++) {
            at[a] = 0.5f * (position[3 * u + a] + position[3 * v + a]);
        }
        int known = count;
        long ends = Hash.mix(Math.min(u, v), Math.max(u, v));
        int middle = vertex(f, w, 0, depth, at, 0, with, Hash.mix(ends, with));
        if (middle == known) {
            bright[middle] = (byte) Math.min(bright[u], bright[v]);
        }
        for (int c = 0; c < channels && middle == known; c++) {
            irradiance[channels * middle + c] = 0.5 * (irradiance[channels * u + c] + irradiance[channels * v + c]);
        }
        return middle;
    }

    /**
     * Finds or makes the vertex at a corner of a face that received at its middle; a new one has the middle's
     * irradiance. It is not bright, whatever the middle is: faces in other blocks with other middles share it.
     *
     * @param w weights of the face's corners, 3 from {@code wAt}, in units of 2^-30; not modified
     */
    int cornerInsteadOf(int middle, int f, int[] w, int wAt, int depth, int with) {
        float[] at = new float[3];
        for (int a = 0; a < 3; a++) {
            double sum = 0;
            for (int k = 0; k < 3; k++) {
                sum += (double) w[wAt + k] / NodePath.ONE * patcher.faces().corner(f, k, a);
            }
            at[a] = (float) sum;
        }
        int known = count;
        int v = vertex(f, w, wAt, depth, at, 0, with, with);
        if (v == known) {
            System.arraycopy(irradiance, channels * middle, irradiance, channels * v, channels);
        }
        return v;
    }

    /** Frees unused room, and forgets the index by which vertices are shared. */
    void trim() {
        makeRoom(count);
        forget();
    }

    /** Forgets the index by which vertices are shared. */
    void forget() {
        index = new LongIndex(256);
    }

    private void makeRoom(int room) {
        position = Arrays.copyOf(position, 3 * room);
        receiver = Arrays.copyOf(receiver, 3 * room);
        face = Arrays.copyOf(face, room);
        key = Arrays.copyOf(key, room);
        made = Arrays.copyOf(made, room);
        buried = Arrays.copyOf(buried, room);
        bright = Arrays.copyOf(bright, room);
        irradiance = Arrays.copyOf(irradiance, channels * room);
        aside = aside == null ? null : Arrays.copyOf(aside, channels * room);
    }

    int count() {
        return count;
    }

    /** Receiving points of all vertices, x, y, z, 3 per vertex; not to be modified. */
    public float[] receivers() {
        return receiver;
    }

    /** A face on which a vertex lies, or a neighbour of that face: the same for whichever face the vertex was made. */
    public int face(int v) {
        return face[v];
    }

    /** The face in whose plane a vertex receives: the same for whichever face the vertex was made. */
    public int plane(int v) {
        return patcher.faces().plane(face[v]);
    }

    /** Key of the place of a vertex, equal for all owners. */
    public long key(int v) {
        return key[v];
    }

    /**
     * Number of powers of two, from 0 to {@link Patcher#MOST_SLACK}, by which the light that one ray may carry to a
     * vertex is raised, as the vertex is bright, see {@link BrightVertices}. A new vertex is as bright as the darker
     * of the ends between which it lies; one at a corner of a face that received at its middle is not bright.
     */
    public int bright(int v) {
        return bright[v];
    }

    /** @param powers see {@link #bright(int)} */
    public void setBright(int v, int powers) {
        bright[v] = (byte) powers;
    }

    /** Number of the split that made a vertex; 0 in the initial mesh. */
    public int made(int v) {
        return made[v];
    }

    /** The vertices that were made by splits with this number, ascending. */
    public int[] madeBy(int with) {
        return IntStream.range(0, count).filter(v -> made[v] == with).toArray();
    }

    public boolean isBuried(int v) {
        return buried[v];
    }

    public void bury(int v) {
        buried[v] = true;
    }

    double[] irradiance() {
        return irradiance;
    }

    /** Sets the irradiance of all vertices aside and starts anew from 0, so that all vertices can gather again. */
    public void setAside() {
        aside = irradiance;
        irradiance = new double[aside.length];
    }

    /**
     * Averages the irradiance gathered anew with the irradiance set aside, unless this is negative in a channel.
     *
     * @param anew weight of the irradiance gathered anew, in (0, 1]
     */
    public void averageAside(double anew) {
        for (int v = 0; v < count; v++) {
            boolean isNegative = false;
            for (int c = 0; c < channels; c++) {
                isNegative |= aside[channels * v + c] < 0;
            }
            for (int i = channels * v; i < channels * (v + 1) && !isNegative; i++) {
                irradiance[i] = anew * irradiance[i] + (1 - anew) * aside[i];
            }
        }
        aside = null;
    }

    /** Whether vertices gather anew while their earlier irradiance is set aside. */
    public boolean isSetAside() {
        return aside != null;
    }

    /** Irradiance of a vertex for display, W/m²: the irradiance set aside, if there is one, else the current. */
    public double shown(int v, int channel) {
        return (aside == null ? irradiance : aside)[channels * v + channel];
    }

    /** Restores the irradiance of a vertex that is set aside, from a saved state, W/m². */
    public void setAside(int v, int channel, double value) {
        aside = aside == null ? new double[irradiance.length] : aside;
        aside[channels * v + channel] = value;
    }
}
