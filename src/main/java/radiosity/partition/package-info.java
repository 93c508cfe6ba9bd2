/**
 * One part of the elements (sections 4.5.4 and 4.5.5 of the paper): gathers light at their vertices, refines their
 * mesh, names the shooters with the most unshot flux.
 *
 * <p>A block of elements belongs to exactly one partition, which alone writes the light on it.
 */
package radiosity.partition;
