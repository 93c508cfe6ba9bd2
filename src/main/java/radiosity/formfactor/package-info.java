/**
 * Form factors and direct light: the light that a receiving point receives from a shooter or from a source without
 * geometry (sections 2.3, 4.5.10 and 4.5.11 of the paper).
 *
 * <p>Calculators keep no state between calls, so any number of threads may use one.
 */
package radiosity.formfactor;
