/**
 * The light on a grid of points, on a surface or on a plane in the air, as a table with its average and uniformity.
 */
package radiosity.output.grid;
