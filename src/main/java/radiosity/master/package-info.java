/**
 * A world whose elements are on other hosts (section 4.5.3 of the paper): hosts that die and come back, checkpoints,
 * replay.
 *
 * <p>Owns the hosts, their blocks and the log of orders from which a lost block is made again.
 */
package radiosity.master;
