/**
 * A world whose elements are on other hosts (section 4.5.3 of the paper): hosts that die and come back, checkpoints,
 * replay.
 *
 * <p>This package owns the hosts, the assignment of blocks to hosts, and the log of orders from which a lost block is
 * rebuilt.
 */
package radiosity.master;
