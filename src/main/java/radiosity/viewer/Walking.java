package radiosity.viewer;

import java.awt.event.KeyEvent;
import java.util.HashMap;
import java.util.Map;
import java.util.function.DoubleSupplier;
import java.util.function.LongSupplier;
import javax.swing.Timer;

/** Walks while keys are held down, at a speed in proportion to the scene's size; on the event thread. */
final class Walking {

    static final int FRAME_MILLISECONDS = 15;
    /** Distance per second, relative to the scene's size. */
    private static final double SPEED = 0.12;
    private static final double HURRY = 4;
    /** Angles per second, radians. */
    private static final double TURN = 1.2;
    private static final double LOOK = 0.8;
    /** Keyboards repeat a held key as release and press: a key counts as held for this time after its release. */
    private static final long REPEAT_NANOSECONDS = 30_000_000;
    /** Longest time that one step covers, seconds. */
    private static final double LONGEST = 0.1;
    private static final long HELD = Long.MAX_VALUE;

    private final Walker walker;
    private final Runnable moved;
    private final DoubleSupplier size;
    /** Key codes, with the time of release, or {@link #HELD}. */
    private final Map<Integer, Long> keys = new HashMap<>();
    private final Timer timer = new Timer(FRAME_MILLISECONDS, e -> tick());
    /** Nanoseconds since any fixed time. */
    private LongSupplier clock = System::nanoTime;
    private boolean hurry;
    private double pace = 1;
    private long last;

    /**
     * @param moved called after each step
     * @param size  returns the size of the scene, scene units
     */
    Walking(Walker walker, Runnable moved, DoubleSupplier size) {
        this.walker = walker;
        this.moved = moved;
        this.size = size;
    }

    /** @param other nanoseconds since any fixed time, used in place of {@link System#nanoTime} */
    void clock(LongSupplier other) {
        clock = other;
        last = clock.getAsLong();
    }

    /** Notes a pressed key; returns whether the key is one of walking. */
    boolean pressed(int key, boolean shift) {
        if (!walks(key)) {
            return false;
        }
        hurry = shift;
        keys.put(key, HELD);
        if (!timer.isRunning()) {
            last = clock.getAsLong();
            timer.start();
        }
        return true;
    }

    void released(int key) {
        keys.computeIfPresent(key, (k, time) -> clock.getAsLong());
    }

    /** Releases every key, as when the window loses the keyboard focus. */
    void stop() {
        keys.clear();
        timer.stop();
    }

    /** Multiplies the speed by a factor. */
    void pace(double factor) {
        pace = Math.max(1.0 / 64, Math.min(64, pace * factor));
    }

    private static boolean walks(int key) {
        return switch (key) {
            case KeyEvent.VK_UP, KeyEvent.VK_DOWN, KeyEvent.VK_LEFT, KeyEvent.VK_RIGHT, KeyEvent.VK_PAGE_UP,
                    KeyEvent.VK_PAGE_DOWN, KeyEvent.VK_W, KeyEvent.VK_S, KeyEvent.VK_A, KeyEvent.VK_D,
                    KeyEvent.VK_Q, KeyEvent.VK_E -> true;
            default -> false;
        };
    }

    /** Walks for the time since the last call, at most {@link #LONGEST} seconds. */
    void tick() {
        long now = clock.getAsLong();
        double seconds = Math.min(LONGEST, (now - last) / 1e9);
        last = now;
        double way = seconds * SPEED * size.getAsDouble() * pace * (hurry ? HURRY : 1);
        walker.turn(seconds * TURN * between(KeyEvent.VK_LEFT, KeyEvent.VK_RIGHT),
                seconds * LOOK * between(KeyEvent.VK_PAGE_UP, KeyEvent.VK_PAGE_DOWN));
        walker.walk(way * (between(KeyEvent.VK_UP, KeyEvent.VK_DOWN) + between(KeyEvent.VK_W, KeyEvent.VK_S)),
                way * between(KeyEvent.VK_D, KeyEvent.VK_A), way * between(KeyEvent.VK_E, KeyEvent.VK_Q));
        moved.run();
        keys.values().removeIf(released -> released != HELD && now - released > REPEAT_NANOSECONDS);
        if (keys.isEmpty()) {
            timer.stop();
        }
    }

    private int between(int more, int less) {
        return (keys.containsKey(more) ? 1 : 0) - (keys.containsKey(less) ? 1 : 0);
    }
}
