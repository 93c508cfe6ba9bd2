/**
 * Which host owns which block, and when moving blocks pays (section 4.3 of the paper).
 */
package radiosity.master.balance;
