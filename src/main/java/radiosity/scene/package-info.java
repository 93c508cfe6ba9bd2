/**
 * The scene: triangles, surfaces, lights, lamps, a camera, images on surfaces. Immutable; made by a reader or a
 * builder.
 *
 * <p>Right-handed coordinates, +Y up; lengths in scene units; light in W per square metre or lm per square metre
 * ({@link radiosity.scene.Units}). Imports no other package of the program.
 */
package radiosity.scene;
