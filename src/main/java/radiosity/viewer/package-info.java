/**
 * The window in which one walks through a lit scene (appendices A and C.4 of the paper).
 *
 * <p>Imports {@code scene}, {@code visibility} and {@code output}. The only package with Java 3D; the light is in the
 * vertices, so there are no Java 3D lights. What is shown is changed on the event thread alone.
 */
package radiosity.viewer;
