package radiosity.partition;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/** Processor time of a round: stable on a busy machine, where wall time says nothing. */
public final class ProcessorTime {

    private final boolean oneThread;

    /** @param threads that compute; with one, that thread is measured, else the process */
    public ProcessorTime(int threads) {
        oneThread = threads == 1;
    }

    /** So far; 0 where the machine does not tell. */
    public double seconds() {
        return oneThread ? ofThread() : ofProcess();
    }

    private static double ofThread() {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        return threads.isCurrentThreadCpuTimeSupported() ? threads.getCurrentThreadCpuTime() * 1e-9 : 0;
    }

    private static double ofProcess() {
        return ManagementFactory.getOperatingSystemMXBean() instanceof com.sun.management.OperatingSystemMXBean system
                ? system.getProcessCpuTime() * 1e-9 : 0;
    }
}
