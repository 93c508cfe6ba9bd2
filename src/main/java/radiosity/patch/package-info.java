/**
 * From triangles to elements (sections 4.2.1, 2.5 and 4.3 of the paper): the patch tree, its initial mesh, when it is
 * subdivided further, and how it is dealt.
 *
 * <p>Imports {@code scene}. Lengths here are relative to the scene's size, see {@link radiosity.patch.Faces}. A tree
 * is changed only by the partition that it belongs to.
 */
package radiosity.patch;
