/** The front of the library: {@link radiosity.Radiosity} reads a scene, calculates its light and hands it over. */
package radiosity;
