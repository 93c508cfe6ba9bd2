package radiosity.master.host;

import radiosity.rmi.RemotePartition;
import radiosity.worker.ServedPartition;

/** The connection of this process to itself: a partition that serves in this process, without RMI. */
public record OwnLink(int threads) implements Link {

    @Override
    public String name() {
        return "this machine";
    }

    @Override
    public RemotePartition connect() {
        return new ServedPartition(threads, line -> { });
    }

    @Override
    public void cut() { }
}
