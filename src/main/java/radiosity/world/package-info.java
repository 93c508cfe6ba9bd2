/**
 * The radiosity calculations (sections 2.2, 3, 4.4 and figure 7 of the paper): rounds of shots over the partitions of a
 * world, on this machine or many.
 *
 * <p>Imports {@code scene}, {@code patch}, {@code visibility} and {@code formfactor}. A block of elements belongs to
 * exactly one {@code Partition}; rounds, shot log and stop rule belong to {@code ProgressiveRadiosity}.
 */
package radiosity.world;
