/**
 * Remote method invocation: addresses, sockets, keys, filters against hostile objects, retries of calls.
 */
package radiosity.rmi;
