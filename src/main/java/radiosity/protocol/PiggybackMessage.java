package radiosity.protocol;

import java.io.IOException;
import radiosity.partition.GhostVertices;

/** What a host may be told with an order, about points that others have, too; see {@link GhostVertices}. */
public enum PiggybackMessage {
    /** What others have gathered for it. */
    GIFT,
    /** At which points others gather from now on, and at which it does. */
    HAND_OVER,
    /** What had arrived when they were handed over at those that it was given. */
    HANDED_OVER;

    public static PiggybackMessage of(int number) throws IOException {
        if (number < 0 || number >= values().length) {
            throw new IOException("order: expected what follows to be below " + values().length + ", got " + number);
        }
        return values()[number];
    }
}
