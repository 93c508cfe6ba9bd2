/**
 * Remote method invocation: addresses, sockets, keys, filters against hostile objects, retries.
 */
package radiosity.rmi;
