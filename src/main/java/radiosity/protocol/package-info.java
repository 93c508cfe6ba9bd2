/**
 * What goes over the wire, into journals and into scene files, as values: shots, orders, answers, states of blocks.
 */
package radiosity.protocol;
