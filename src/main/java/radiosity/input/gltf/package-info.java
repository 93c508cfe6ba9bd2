/**
 * Reads glTF 2.0 files and binaries.
 *
 * <p>{@link radiosity.input.gltf.GltfReader} is the way in; no state is kept between two scenes.
 */
package radiosity.input.gltf;
