/**
 * The patch tree in arrays (section 4.5.7 of the paper): receiving points, the light on elements, subdivision, blocks.
 *
 * <p>Only the partition that owns a tree changes it.
 */
package radiosity.mesh;
