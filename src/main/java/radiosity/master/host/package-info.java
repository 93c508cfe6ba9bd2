/**
 * One host as its master sees it: the session with its calls and heartbeat; how hosts are found and lost.
 */
package radiosity.master.host;
