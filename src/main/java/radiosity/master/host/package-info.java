/**
 * One host as its master sees it: a session, its calls and its heartbeat, how it is found and how it is lost.
 */
package radiosity.master.host;
