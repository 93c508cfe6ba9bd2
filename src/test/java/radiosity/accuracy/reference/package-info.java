/**
 * Reference radiosities that the project makes itself: a small path tracer in double precision that shares neither
 * intersection nor form factor nor mesh with the program, two rooms, and the file of points that it writes.
 */
package radiosity.accuracy.reference;
