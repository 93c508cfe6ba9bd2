/**
 * The light baked into textures (section 4.6 of the paper).
 */
package radiosity.output.lightmap;
