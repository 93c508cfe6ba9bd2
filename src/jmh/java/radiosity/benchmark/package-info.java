/** How fast the innermost loops are; timings are read as ratios within one run. */
package radiosity.benchmark;
