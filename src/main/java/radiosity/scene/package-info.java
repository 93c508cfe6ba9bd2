/**
 * What there is to light: triangles, surfaces, lights, lamps, a camera, images on surfaces. Immutable; made by a
 * reader or a builder.
 *
 * <p>Right-handed coordinates, +Y up; lengths in scene units; light in W per square unit. Imports {@code util} only.
 */
package radiosity.scene;
