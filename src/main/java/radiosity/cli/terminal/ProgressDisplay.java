package radiosity.cli.terminal;

import radiosity.solution.Progress;

/** Where the user sees how far a calculation is. */
public interface ProgressDisplay extends AutoCloseable {

    /** @param name of what begins now and is no round, such as "reading a.lws" */
    void phase(String name);

    /** After a round. */
    void show(Progress progress);

    /** A line besides, such as an error that does not end the work. */
    void message(String line);

    /** Ends it: what is printed afterwards stands on a line of its own. */
    @Override
    void close();
}
