package radiosity.torture;

import java.nio.file.Path;

/**
 * A scene on the disk.
 *
 * @param kind      what kind it is
 * @param file      the LightWave scene
 * @param library   directory in which its objects lie when they do not lie beside it, else null
 * @param prefix    with which the scene names that directory, or null
 * @param area      about the sum of its surfaces' areas, square units; 0 for unknown
 * @param lightFlux at most so much flux comes from lights without a surface, W per channel
 * @param size      largest extent, units
 */
record MadeScene(SceneKind kind, Path file, Path library, String prefix, double area, double lightFlux, double size) {
}
