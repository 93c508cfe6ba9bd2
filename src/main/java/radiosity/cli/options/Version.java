package radiosity.cli.options;

import picocli.CommandLine.IVersionProvider;

/** Which program this is. */
final class Version implements IVersionProvider {

    @Override
    public String[] getVersion() {
        return new String[] {text()};
    }

    /** Title and version as the jar states them. */
    static String text() {
        String version = Version.class.getPackage().getImplementationVersion();
        return "radiosity " + (version == null ? "(not from a jar)" : version);
    }
}
