package radiosity.protocol;

import java.io.DataInputStream;
import java.io.DataOutput;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import radiosity.mesh.face.Faces;
import radiosity.util.ExactSum;

/** The answer of a partition after a round: its best candidates for the next, and its part of the energy ledger. */
public final class Answer {

    /** Shooters for the next round, largest unshot flux first. */
    public final List<Shot> candidates = new ArrayList<>();
    /** One per layer: sum of |U| A over the elements and the layer's colours, W. */
    public final ExactSum[] unshotFlux;
    /** One per channel: flux that arrived at the elements, W. */
    public final ExactSum[] received;
    /** One per channel: the part of {@link #received} that was not reflected, W. */
    public final ExactSum[] absorbed;
    /** One per channel: signed sum of U A over the elements, W. */
    public final ExactSum[] unshot;
    public int elements;

    /** @param scale about the flux that is emitted, W: the scale of all {@link ExactSum}s */
    public Answer(Faces faces, double scale) {
        int channels = faces.channels();
        unshotFlux = sums(faces.layers(), scale);
        received = sums(channels, scale);
        absorbed = sums(channels, scale);
        unshot = sums(channels, scale);
    }

    /** Shares the sums of another answer; has no candidates. */
    private Answer(Answer other) {
        unshotFlux = other.unshotFlux.clone();
        received = other.received;
        absorbed = other.absorbed;
        unshot = other.unshot;
        elements = other.elements;
    }

    private static ExactSum[] sums(int count, double scale) {
        ExactSum[] sums = new ExactSum[count];
        Arrays.setAll(sums, i -> new ExactSum(scale));
        return sums;
    }

    private List<ExactSum[]> sums() {
        return List.of(unshotFlux, received, absorbed, unshot);
    }

    /** Adds the answers of other partitions; keeps the {@code most} candidates with the largest flux. */
    public void add(List<Answer> others, int most) {
        others.forEach(other -> {
            candidates.addAll(other.candidates);
            addSums(other);
        });
        Collections.sort(candidates);
        if (candidates.size() > most) {
            candidates.subList(most, candidates.size()).clear();
        }
    }

    /** A copy of this answer without the candidates that are also among the given shooters. */
    public Answer without(List<Shot> shots, Faces faces, double scale) {
        Set<Shot.Place> places = shots.stream().map(Shot::place).collect(Collectors.toSet());
        Answer rest = new Answer(faces, scale);
        rest.addSums(this);
        candidates.stream().filter(shot -> !places.contains(shot.place())).forEach(rest.candidates::add);
        return rest;
    }

    /** The sums of this answer, but the unshot flux of {@code other}; without candidates. */
    public Answer withUnshotFlux(Answer other) {
        Answer answer = new Answer(this);
        for (int i = 0; i < unshotFlux.length; i++) {
            answer.unshotFlux[i] = other.unshotFlux[i];
        }
        return answer;
    }

    /** Adds the sums and the number of elements of another answer, not its candidates. */
    public void addSums(Answer other) {
        for (int q = 0; q < sums().size(); q++) {
            for (int i = 0; i < sums().get(q).length; i++) {
                sums().get(q)[i].add(other.sums().get(q)[i]);
            }
        }
        elements += other.elements;
    }

    public void write(DataOutput out) throws IOException {
        Wire.write(candidates, received.length, out);
        for (ExactSum[] sums : sums()) {
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

    /** Fills this answer, which must be empty, from what {@link #write} wrote. */
    public void read(DataInputStream in) throws IOException {
        candidates.addAll(Wire.shots(in));
        for (ExactSum[] sums : sums()) {
            for (ExactSum sum : sums) {
                sum.with(in.readLong(), in.readLong());
            }
        }
        elements = in.readInt();
    }
}
