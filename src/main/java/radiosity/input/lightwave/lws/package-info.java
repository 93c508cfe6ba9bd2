/**
 * Reads LightWave scenes (LWSC 1 to 5): items, motions, lights, camera.
 */
package radiosity.input.lightwave.lws;
