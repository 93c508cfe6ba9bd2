/**
 * The window in which one walks through a scene (section 4.6 and appendix C.4 of the paper), in Java 3D.
 *
 * <p>The only package with Java 3D; the light is in the vertices, so there are no Java 3D lights. What is shown is
 * changed on the event thread alone.
 */
package radiosity.viewer;
