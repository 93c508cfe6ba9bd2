/**
 * The program that writes the shipped scenes of the folder {@code scenes}, and tests of what it writes.
 *
 * <p>{@link radiosity.scenes.MakeScenes} is the program. {@link radiosity.scenes.CornellBox} and
 * {@link radiosity.scenes.Study} are the scenes; the rest models solids and writes LightWave files.
 */
package radiosity.scenes;
