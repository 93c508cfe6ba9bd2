/**
 * How much of a shooter's light reaches a receiving point (section 2.3 of the paper).
 *
 * <p>Imports {@code scene}, {@code patch} and {@code visibility}. Calculators keep no state between calls, so any
 * number of threads may use one.
 */
package radiosity.formfactor;
