package radiosity.cli.options;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Stack;
import picocli.CommandLine.IParameterConsumer;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import radiosity.rmi.HostAddress;

/** Options of distributed mode. */
public final class HostOptions {

    @Option(names = {"-h", "--hosts"}, paramLabel = "<n> <h1> .. <hn>", arity = "1..*", hideParamSyntax = true,
            parameterConsumer = HostsConsumer.class,
            description = "Hosts to use in distributed mode: their number, then host or host:port of each;"
                    + " an IPv6 address with a port in brackets: [address]:port.")
    public List<HostAddress> hosts;

    @Option(names = {"-key", "--key"}, paramLabel = "<file>",
            description = "The key file that the hosts were started with.")
    public Path key;

    /** Parses {@code <n> <h1> ... <hn>}. */
    static final class HostsConsumer implements IParameterConsumer {
        @Override
        public void consumeParameters(Stack<String> arguments, ArgSpec option, CommandSpec command) {
            Arguments.once(option);
            String expected = "the number of hosts and their names, as in -h 3 andreas daniel igge (see --help)";
            int count = Arguments.convert(new Values.AtLeastOne(),
                    Arguments.next(arguments, option, expected), option);
            List<HostAddress> hosts = new ArrayList<>();
            while (hosts.size() < count) {
                if (arguments.isEmpty() || arguments.peek().startsWith("-") || Arguments.isModel(arguments.peek())) {
                    throw Arguments.wrong(option, "expected the names of " + count
                            + (count == 1 ? " host, got " : " hosts, got ")
                             + hosts.size() + (arguments.isEmpty() ? "" : " before " + arguments.peek()));
                }
                add(hosts, arguments.pop(), option);
            }
            option.setValue(hosts);
        }

        private static void add(List<HostAddress> hosts, String text, ArgSpec option) {
            try {
                HostAddress host = HostAddress.parse(text);
                if (hosts.stream().anyMatch(host::isSame)) {
                    throw Arguments.wrong(option, "expected every host once, got " + text + " twice");
                }
                hosts.add(host);
            } catch (IllegalArgumentException e) {
                throw Arguments.wrong(option, e.getMessage());
            }
        }
    }
}
