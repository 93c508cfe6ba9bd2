/**
 * What stands between two points (section 2.4 of the paper): a hierarchy of bounding boxes over triangles.
 *
 * <p>Imports {@code scene}. The hierarchy sees corners in arrays, never a surface. It is made once and then only read,
 * by any number of threads.
 */
package radiosity.visibility;
