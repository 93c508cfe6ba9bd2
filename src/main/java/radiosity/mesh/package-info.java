/**
 * The patch tree in arrays (section 4.5.7 of the paper): receiving points, the light on elements, subdivision, blocks.
 *
 * <p>A tree is changed only by the partition that it belongs to.
 */
package radiosity.mesh;
