/**
 * Numbers, sums and loops that give the same bits on every machine: hashes, exact sums, boxes, disjoint sets, a
 * parallel loop.
 *
 * <p>Imports only points and directions, from {@code scene}.
 */
package radiosity.util;
