package radiosity.mesh;

import java.util.Arrays;
import java.util.stream.IntStream;
import radiosity.mesh.face.NodePath;
import radiosity.util.ArraySize;
import radiosity.util.Hash;
import radiosity.util.LongIndex;

/** The vertices of some patch trees, in arrays: where light is gathered, and what has arrived there. */
final class ReceivingPoints {

    /** Weights of a face's corners in its middle. */
    private static final int[] MIDDLE = {NodePath.ONE / 3, NodePath.ONE / 3, NodePath.ONE - 2 * (NodePath.ONE / 3)};

    private final Patcher patcher;
    private final int channels;
    private int count;
    /** 3 per vertex. */
    private float[] position = new float[3 * 64];
    /** 3 per vertex: where its light is gathered. */
    private float[] receiver = new float[3 * 64];
    /** 1 per vertex: the face that stands for it, the same whoever has it; see {@link VertexKey#face}. */
    private int[] face = new int[64];
    /** 1 per vertex: what it is, whoever owns it. */
    private long[] key = new long[64];
    /** 1 per vertex: number of the split that made it; 0 in the initial mesh. */
    private int[] made = new int[64];
    /** 1 per vertex: inside another object; its elements do without it. */
    private boolean[] buried = new boolean[64];
    /** channels per vertex: H in W/m². */
    private double[] irradiance;
    /** channels per vertex: H in W/m² that is set aside while all vertices gather anew; else null. */
    private double[] aside;
    /** Vertices of the initial mesh by key, and later ones by key and number of the split. */
    private LongIndex index = new LongIndex(256);

    ReceivingPoints(Patcher patcher) {
        this.patcher = patcher;
        channels = patcher.faces().channels();
        irradiance = new double[channels * 64];
    }

    /**
     * The vertex with certain weights of a face's corners; made where it is not there yet.
     *
     * @param w    weights, 3 from {@code wAt}, in units of 2^-30; not modified
     * @param at   its position, 3 from {@code from}; not modified
     * @param with 0 in the initial mesh, else number of the split: only vertices of one split are shared
     */
    int vertex(int f, int[] w, int wAt, int depth, float[] at, int from, int with) {
        return vertex(f, w, wAt, depth, at, from, with, with);
    }

    /** The vertex in the middle of a face. */
    int middle(int f, float[] corners) {
        float[] at = new float[3];
        for (int a = 0; a < 3; a++) {
            at[a] = (corners[a] + corners[3 + a] + corners[6 + a]) / 3;
        }
        return vertex(f, MIDDLE, 0, 0, at, 0, 0);
    }

    /** @param shared 0 where all of this place are one vertex, else what those that are one have in common */
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
     * The vertex halfway between two; a new one has received what they have in the mean. It is shared only by who has
     * both ends in common: ends of different histories would give it another value from each side, and which of them
     * came first would depend on how blocks are dealt.
     */
    int between(int u, int v, int f, int[] w, int depth, int with) {
        float[] at = new float[3];
        for (int a = 0; a < 3; a++) {
            at[a] = 0.5f * (position[3 * u + a] + position[3 * v + a]);
        }
        int known = count;
        long ends = Hash.mix(Math.min(u, v), Math.max(u, v));
        int middle = vertex(f, w, 0, depth, at, 0, with, Hash.mix(ends, with));
        for (int c = 0; c < channels && middle == known; c++) {
            irradiance[channels * middle + c] = 0.5 * (irradiance[channels * u + c] + irradiance[channels * v + c]);
        }
        return middle;
    }

    /**
     * The vertex at a corner of a face that received at its middle only; a new one has received what the middle has.
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

    /** Gives back what room there is, and forgets by what vertices could be shared. */
    void trim() {
        makeRoom(count);
        forget();
    }

    /** Forgets by what vertices could be shared. */
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
        irradiance = Arrays.copyOf(irradiance, channels * room);
        aside = aside == null ? null : Arrays.copyOf(aside, channels * room);
    }

    int count() {
        return count;
    }

    float[] receivers() {
        return receiver;
    }

    int face(int v) {
        return face[v];
    }

    int plane(int v) {
        return patcher.faces().plane(face[v]);
    }

    long key(int v) {
        return key[v];
    }

    int made(int v) {
        return made[v];
    }

    int[] madeBy(int with) {
        return IntStream.range(0, count).filter(v -> made[v] == with).toArray();
    }

    boolean isBuried(int v) {
        return buried[v];
    }

    void bury(int v) {
        buried[v] = true;
    }

    double[] irradiance() {
        return irradiance;
    }

    /** Sets aside what all vertices have received: they have received nothing then. */
    void setAside() {
        aside = irradiance;
        irradiance = new double[aside.length];
    }

    /**
     * All vertices have gathered anew: that is averaged with what is set aside, unless this is negative.
     *
     * @param anew weight of what was gathered anew, in (0, 1]
     */
    void averageAside(double anew) {
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

    boolean isSetAside() {
        return aside != null;
    }

    /** What is shown of a vertex: what was set aside, else what it has received, W/m². */
    double shown(int v, int channel) {
        return (aside == null ? irradiance : aside)[channels * v + channel];
    }

    /** For whoever restores what was saved. */
    void setAside(int v, int channel, double value) {
        aside = aside == null ? new double[irradiance.length] : aside;
        aside[channels * v + channel] = value;
    }
}
