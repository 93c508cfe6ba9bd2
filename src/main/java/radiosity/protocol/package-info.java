/**
 * Values that go over the network, into journals and into scene files: shots, orders, answers, states of blocks.
 */
package radiosity.protocol;
