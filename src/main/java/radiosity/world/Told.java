package radiosity.world;

import java.io.IOException;

/** What a host may be told with an order, about points that others have, too; see {@link BorderPoints}. */
enum Told {
    /** What others have gathered for it. */
    GIFT,
    /** At which points others gather from now on, and at which it does. */
    HAND_OVER,
    /** What had arrived when they were handed over at those that it was given. */
    HANDED_OVER;

    static Told of(int number) throws IOException {
        if (number < 0 || number >= values().length) {
            throw new IOException("order: expected what follows to be below " + values().length + ", got " + number);
        }
        return values()[number];
    }
}
