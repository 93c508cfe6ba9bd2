/**
 * The library: loads or builds a scene, calculates its light, answers questions about it, and writes it.
 *
 * <p>The programs are run from the class path, where no module hides anything; what only they need (picocli, JLine, the
 * progress bar, Java 3D) no module names.
 */
module radiosity {
    requires com.fasterxml.jackson.databind;
    requires java.desktop;
    requires static java.logging;
    requires java.management;
    requires java.rmi;
    requires static jdk.httpserver;
    requires static jdk.management;

    exports radiosity;
    exports radiosity.output.points;
    exports radiosity.scene;
    exports radiosity.settings;
    exports radiosity.solution;
    exports radiosity.rmi to java.rmi;
}
