package radiosity.input.gltf;

/**
 * How a node changes the vertices of its mesh, at rest.
 *
 * @param weights of morph targets; may be empty
 * @param skin    moves vertices straight to the scene; null for none
 */
record Shape(double[] weights, Skin skin) {
}
