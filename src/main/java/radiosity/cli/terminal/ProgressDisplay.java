package radiosity.cli.terminal;

import radiosity.solution.Progress;

/** Shows the user how far a render is; a lambda expression that prints lines shows these alone. */
@FunctionalInterface
public interface ProgressDisplay extends AutoCloseable {

    /** @param name of a phase without rounds that begins, such as "reading a.lws" */
    default void phase(String name) { }

    /**
     * Shows how far a long task after the calculation is.
     *
     * @param name of the task, such as "drawing a.png"
     * @param done part of the task that is done, from 0 to 1
     * @param all  part of all such tasks of the render that is done, from 0 to 1
     */
    default void part(String name, double done, double all) { }

    /** Shows the progress after a round. */
    default void show(Progress progress) { }

    /** Prints a line, such as an error that does not end the work. */
    void message(String line);

    /** Ends the display, so that text printed later begins on a new line. */
    @Override
    default void close() { }
}
