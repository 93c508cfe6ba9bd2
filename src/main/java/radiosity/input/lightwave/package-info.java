/**
 * Reads LightWave scenes and objects: finds the files, places the objects, brings surfaces, lights and camera together.
 *
 * <p>{@link radiosity.input.lightwave.LightWaveReader} is the way in; no state is kept between two scenes.
 */
package radiosity.input.lightwave;
