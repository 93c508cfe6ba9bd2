/**
 * The window in which the user walks through a scene (section 4.6 and appendix C.4 of the paper), in Java 3D.
 *
 * <p>No other package uses Java 3D. Vertices hold their light, so there are no Java 3D lights. The scene shown is
 * changed only on the event thread.
 */
package radiosity.viewer;
