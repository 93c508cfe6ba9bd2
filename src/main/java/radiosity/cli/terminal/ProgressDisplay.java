package radiosity.cli.terminal;

import radiosity.solution.Progress;

/** Where the user sees how far a calculation is. */
public interface ProgressDisplay extends AutoCloseable {

    /** @param name of what begins now and is no round, such as "reading a.lws" */
    void phase(String name);

    /**
     * How far something is that takes a while and is no calculation.
     *
     * @param name of it, such as "drawing a.png"
     * @param done part of it, from 0 to 1
     */
    void part(String name, double done);

    /** After a round. */
    void show(Progress progress);

    /** A line besides, such as an error that does not end the work. */
    void message(String line);

    /** Ends it: what is printed afterwards stands on a line of its own. */
    @Override
    void close();
}
