/**
 * The input's own model with its light in lightmaps, for other programs.
 */
package radiosity.output.model;
