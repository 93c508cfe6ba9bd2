package radiosity.torture;

/** What is done to a render, or to what it needs. */
enum Fault {

    /** Nothing, but other threads, hosts and compilers than the render it is compared with. */
    NONE,
    /** SIGTERM; then -tf. */
    TERM,
    /** Ctrl-C on a terminal; then -tf. */
    CONTROL_C,
    /** A key pressed on a terminal; then -tf. */
    KEY,
    /** SIGTERM, -tf, SIGTERM, -tf, ... */
    TERM_AGAIN_AND_AGAIN,
    /** kill -9; then the same command. */
    MASTER_KILLED,
    /** kill -9, several times; then the same command. */
    MASTER_KILLED_AGAIN,
    /** SIGSTOP, and SIGCONT a second or so later. */
    MASTER_PAUSED,
    /** A disk that is too small; then the same command on a larger one. */
    FULL_DISK,
    /** A limit for the size of files; then the same command without. */
    FILE_LIMIT,
    /** A heap that may be too small; then the same command with a larger one. */
    HEAP,
    /** Two renders to the same file. */
    TWO_AT_ONCE,
    /** kill -9 of one worker. */
    WORKER_KILLED,
    /** kill -9 of all workers: the master goes on alone. */
    WORKERS_KILLED,
    /** kill -9 of a worker, and a new one in its place. */
    WORKER_RESTARTED,
    /** SIGSTOP of a worker, and SIGCONT some seconds later. */
    WORKER_PAUSED,
    /** SIGSTOP of a worker for good. */
    WORKER_SILENT,
    /** A worker that is started after the master. */
    WORKER_LATE,
    /** A worker whose heap may be too small. */
    WORKER_HEAP,
    /** Hosts on which no worker runs. */
    NO_WORKER,
    /** A command line that cannot be meant. */
    WRONG_COMMAND,
    /** A saved scene or a journal that was cut off, or of which a byte was changed. */
    DAMAGED_FILE;

    /** Whether there must be hosts. */
    boolean needsWorkers() {
        return name().startsWith("WORKER");
    }

    /** Whether the render is ended before it is done, and saved. */
    boolean stops() {
        return this == TERM || this == CONTROL_C || this == KEY || this == TERM_AGAIN_AND_AGAIN;
    }

    boolean needsTerminal() {
        return this == CONTROL_C || this == KEY;
    }
}
