package radiosity.cli.options;

import java.nio.file.Path;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import radiosity.rmi.HostAddress;

/** The command line of {@code PartitionServer}. */
@Command(name = "PartitionServer", sortOptions = false,
        customSynopsis = "PartitionServer [parameters]",
        description = "%nComputes a part of a scene for RadiosityRenderer -h on another machine; "
                + "one renderer at a time,"
                + " until it is ended.%n",
        footer = {"", "Exit codes: 1 failed, say a port in use; 2 wrong command line; 3 a file cannot be read; "
                + "130 ended by Ctrl-C; 143 ended by SIGTERM."})
public final class ServerOptions {

    @Option(names = {"-port", "--port"}, paramLabel = "<n>", converter = Values.Port.class,
            description = "Port to listen on, the only one that a firewall has to open; that of a running rmiregistry"
                    + " is shared with it. Default: " + HostAddress.DEFAULT_PORT + ".")
    public int port = HostAddress.DEFAULT_PORT;

    @Option(names = "--second-port", paramLabel = "<n>", converter = Values.Port.class,
            description = "With a running rmiregistry: port of the partition itself. Default: any.")
    public Integer secondPort;

    @Option(names = {"-host", "--host"}, paramLabel = "<name>", converter = Values.HostName.class,
            description = "Name by which others reach this machine. Default: as it calls itself.")
    public String host;

    @Option(names = {"-bind", "--bind"}, paramLabel = "<address>",
            description = "Listen on this address only. Default: on all of this machine's.")
    public String bind;

    @Option(names = {"-key", "--key"}, paramLabel = "<file>",
            description = "Serve only who has the same key file (scripts/make-key), and encrypt everything.")
    public Path key;

    @Option(names = {"-t", "--threads"}, paramLabel = "<n>", converter = Values.AtLeastOne.class,
            description = "Number of threads. Default: one per processor.")
    public int threads = Runtime.getRuntime().availableProcessors();

    @Mixin(name = CommonOptions.GROUP)
    public final CommonOptions common = new CommonOptions();
}
