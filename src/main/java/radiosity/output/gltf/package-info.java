/**
 * The scene file, a glTF 2.0 binary: written from a {@link radiosity.solution.Solution}, which is not modified, read
 * and described.
 */
package radiosity.output.gltf;
