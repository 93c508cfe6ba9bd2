/**
 * What a PartitionServer serves (section 4.5.6 of the paper): one session of a master at a time.
 */
package radiosity.worker;
