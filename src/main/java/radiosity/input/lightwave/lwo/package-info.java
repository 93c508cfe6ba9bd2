/**
 * Reads LightWave objects (LWOB, LWLO, LWO2, LWO3) as their files list them.
 */
package radiosity.input.lightwave.lwo;
