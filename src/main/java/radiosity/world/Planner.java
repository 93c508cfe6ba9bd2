package radiosity.world;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;

/** Decides who shoots in the next round; a schedule at work. */
sealed interface Planner permits ShootAndSort, Prediction {

    /**
     * The next round.
     *
     * @param last   what the partitions answered to the last one
     * @param unsent unshot flux relative to the emitted
     * @return what to do, or null where nothing is left
     */
    Order next(Answer last, double unsent) throws IOException;

    /** Told that so many patches have shot. */
    void shot(int patches);

    /** Whether so little unshot flux, relative to the emitted, is the end. */
    boolean isEnough(double unsent, double wanted);

    /** What resuming needs beside the elements. */
    void write(DataOutput out) throws IOException;

    void read(DataInput in) throws IOException;
}
