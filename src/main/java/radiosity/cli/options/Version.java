package radiosity.cli.options;

import picocli.CommandLine.IVersionProvider;

/** Name and version of the program. */
final class Version implements IVersionProvider {

    @Override
    public String[] getVersion() {
        return new String[] {text()};
    }

    /** Name and version; the version is read from the jar's manifest. */
    static String text() {
        String version = Version.class.getPackage().getImplementationVersion();
        return "radiosity " + (version == null ? "(not from a jar)" : version);
    }
}
