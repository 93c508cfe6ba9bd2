package radiosity.world;

import java.io.DataInputStream;
import java.io.DataOutput;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** What a partition says after a round: its best candidates for the next one, and its part of the ledger. */
final class Answer {

    /** Largest unshot flux first. */
    final List<Shot> candidates = new ArrayList<>();
    /** Sum of |U| A over elements and channels, W. */
    final ExactSum unshotFlux;
    /** One per channel, W: what arrived. */
    final ExactSum[] received;
    /** One per channel, W: the part of it that was not reflected. */
    final ExactSum[] absorbed;
    /** One per channel, W: signed. */
    final ExactSum[] unshot;
    int elements;

    /** @param scale flux that is emitted, W */
    Answer(int channels, double scale) {
        unshotFlux = new ExactSum(scale);
        received = sums(channels, scale);
        absorbed = sums(channels, scale);
        unshot = sums(channels, scale);
    }

    private static ExactSum[] sums(int channels, double scale) {
        ExactSum[] sums = new ExactSum[channels];
        for (int c = 0; c < channels; c++) {
            sums[c] = new ExactSum(scale);
        }
        return sums;
    }

    /** Adds another partition's answer; keeps the best candidates of both. */
    void add(Answer other, int most) {
        candidates.addAll(other.candidates);
        Collections.sort(candidates);
        if (candidates.size() > most) {
            candidates.subList(most, candidates.size()).clear();
        }
        addSums(other);
    }

    void addSums(Answer other) {
        unshotFlux.add(other.unshotFlux);
        for (int c = 0; c < received.length; c++) {
            received[c].add(other.received[c]);
            absorbed[c].add(other.absorbed[c]);
            unshot[c].add(other.unshot[c]);
        }
        elements += other.elements;
    }

    void write(DataOutput out) throws IOException {
        Wire.write(candidates, received.length, out);
        write(out, unshotFlux);
        for (ExactSum[] sums : List.of(received, absorbed, unshot)) {
            for (ExactSum sum : sums) {
                write(out, sum);
            }
        }
        out.writeInt(elements);
    }

    private static void write(DataOutput out, ExactSum sum) throws IOException {
        out.writeLong(sum.high());
        out.writeLong(sum.low());
    }

    void read(DataInputStream in) throws IOException {
        candidates.addAll(Wire.shots(in));
        unshotFlux.with(in.readLong(), in.readLong());
        for (ExactSum[] sums : List.of(received, absorbed, unshot)) {
            for (ExactSum sum : sums) {
                sum.with(in.readLong(), in.readLong());
            }
        }
        elements = in.readInt();
    }
}
