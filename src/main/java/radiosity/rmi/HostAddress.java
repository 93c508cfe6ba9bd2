package radiosity.rmi;

import java.rmi.registry.Registry;

/**
 * The address on which a host listens.
 *
 * @param host name or network address of the host, not blank
 * @param port port of the host's registry, 1 to 65535
 */
public record HostAddress(String host, int port) {

    /** The port where the user names none. */
    public static final int DEFAULT_PORT = Registry.REGISTRY_PORT;
    private static final int MOST = 65535;

    public HostAddress {
        if (host.isBlank() || port < 1 || port > MOST) {
            throw new IllegalArgumentException("expected host or host:port, got " + host + ":" + port);
        }
    }

    /** @param text {@code host}, {@code host:port}, {@code [address]} or {@code [address]:port} */
    public static HostAddress parse(String text) {
        int colon = text.lastIndexOf(':');
        boolean bare = colon < 0 || text.endsWith("]") || text.indexOf(':') != colon && !text.startsWith("[");
        String host = bare ? text : text.substring(0, colon);
        try {
            int port = bare ? DEFAULT_PORT : Integer.parseInt(text.substring(colon + 1));
            return new HostAddress(host.replaceAll("^\\[|]$", ""), port);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("expected host or host:port, got " + text, e);
        }
    }

    /** Whether this is the same host name, in capitals or not, and port. */
    public boolean isSame(HostAddress other) {
        return host.equalsIgnoreCase(other.host) && port == other.port;
    }

    /** The address as {@link #parse} reads it. */
    @Override
    public String toString() {
        String bracketed = host.indexOf(':') < 0 ? host : "[" + host + "]";
        return port == DEFAULT_PORT ? host : bracketed + ":" + port;
    }
}
