/**
 * Derives the solution of an edited scene from that of the scene before: finds what differs, transfers the mesh and its
 * light, and subtracts the light that no longer arrives.
 *
 * <p>S. Chen, Incremental radiosity, 1990; D. George, F. Sillion, D. Greenberg, Radiosity redistribution for dynamic
 * environments, 1990.
 */
package radiosity.change;
