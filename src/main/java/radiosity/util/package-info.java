/**
 * Numbers, sums and loops that are the same bits on every machine: hashes, exact sums, a parallel loop.
 *
 * <p>Imports no other package of the program.
 */
package radiosity.util;
