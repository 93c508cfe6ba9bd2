/**
 * The side of a host: a PartitionServer serves one session of a master at a time (section 4.5.6 of the paper).
 */
package radiosity.worker;
