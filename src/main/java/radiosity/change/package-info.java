/**
 * From a solution to that of an edited scene: what differs, what of the mesh and its light stays, and the light that no
 * longer arrives taken back.
 *
 * <p>S. Chen, Incremental radiosity, 1990; D. George, F. Sillion, D. Greenberg, Radiosity redistribution for dynamic
 * environments, 1990.
 */
package radiosity.change;
