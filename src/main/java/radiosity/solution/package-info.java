/**
 * What comes out: radiosity per vertex, energy ledger, certificate, progress, statistics.
 */
package radiosity.solution;
