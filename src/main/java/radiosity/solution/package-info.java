/**
 * Results of a calculation: light per vertex, energy ledger, certificate of error, progress, statistics of hosts.
 */
package radiosity.solution;
