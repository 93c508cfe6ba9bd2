package radiosity.master.host;

import radiosity.rmi.RemotePartition;
import radiosity.worker.ServedPartition;

/** The way from this process to itself. */
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
