/** The front of the library: {@link radiosity.Radiosity} reads a scene, calculates its light and returns the result. */
package radiosity;
