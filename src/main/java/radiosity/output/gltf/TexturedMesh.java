package radiosity.output.gltf;

/**
 * One side of one surface with its light in a texture.
 *
 * @param positions x, y, z relative to the file's origin, 3 per vertex, scene units; 3 vertices per triangle,
 *                  counter-clockwise seen from the visible side
 * @param places    u, v in the texture, v downwards, 2 per vertex
 * @param png       the texture: radiosity after the file's tone mapping, sRGB
 */
public record TexturedMesh(float[] positions, float[] places, byte[] png) {
}
