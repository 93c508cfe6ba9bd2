package radiosity.input.gltf;

/**
 * How a node deforms the vertices of its mesh, at rest.
 *
 * @param weights weights of the morph targets; may be empty
 * @param skin    moves the vertices directly to the scene's space; null for none
 */
record Shape(double[] weights, Skin skin) {
}
