/**
 * What a scene is: original triangles in arrays, surfaces, lights, a camera (section 2.1 and 4.5.1 of the paper).
 *
 * <p>Imports no other package of the program. Every type is immutable; a {@link radiosity.scene.Scene} is made by a
 * reader and changed by nobody. Right-handed coordinates, +Y up; lengths in scene units; light in W/m².
 */
package radiosity.scene;
