package radiosity.solver;

import radiosity.protocol.Order;

/**
 * How the calculation of an earlier scene ended.
 *
 * @param rules     tolerances and weights of the last round
 * @param isSettled whether the unshot radiosity of the elements is nothing but the noise of rays
 */
record EarlierEnd(Order.Rules rules, boolean isSettled) { }
