package radiosity.viewer;

import java.awt.event.KeyEvent;
import java.util.HashMap;
import java.util.Map;
import java.util.function.DoubleSupplier;
import java.util.function.LongSupplier;
import javax.swing.Timer;

/** Walks while keys are held down, as fast as the scene is large; on the event thread. */
final class Walking {

    static final int FRAME_MILLISECONDS = 15;
    /** Per second, of the scene's size. */
    private static final double SPEED = 0.12;
    private static final double HURRY = 4;
    /** Radians per second. */
    private static final double TURN = 1.2;
    private static final double LOOK = 0.8;
    /** A key that repeats is released and pressed again at once: shorter than this it counts as held. */
    private static final long REPEAT_NANOSECONDS = 30_000_000;
    /** After a pause the first step is no longer than this, seconds. */
    private static final double LONGEST = 0.1;
    private static final long HELD = Long.MAX_VALUE;

    private final Walker walker;
    private final Runnable moved;
    private final DoubleSupplier size;
    /** Key codes, with the time of their release or {@link #HELD}. */
    private final Map<Integer, Long> keys = new HashMap<>();
    private final Timer timer = new Timer(FRAME_MILLISECONDS, e -> tick());
    /** Nanoseconds from any beginning. */
    private LongSupplier clock = System::nanoTime;
    private boolean hurry;
    private double pace = 1;
    private long last;

    /** @param size of the scene, scene units */
    Walking(Walker walker, Runnable moved, DoubleSupplier size) {
        this.walker = walker;
        this.moved = moved;
        this.size = size;
    }

    /** @param other nanoseconds from any beginning; {@link System#nanoTime} unless this is called */
    void clock(LongSupplier other) {
        clock = other;
        last = clock.getAsLong();
    }

    /** Returns whether the key is one of walking. */
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

    /** Lets go of every key, as when the window is no longer the one typed into. */
    void stop() {
        keys.clear();
        timer.stop();
    }

    /** Walks faster or slower from now on. */
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

    /** Walks for the time since the last call. */
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
