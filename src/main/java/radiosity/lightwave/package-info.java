/**
 * Reads LightWave scenes (LWSC 1 to 5) and objects (LWOB, LWLO, LWO2, LWO3) into a {@link radiosity.scene.Scene}.
 *
 * <p>Imports {@code radiosity.scene} only; loads no class of {@code java.awt} or Java 3D. One reader of one file is used
 * by one thread; nothing is kept between two scenes. {@link radiosity.lightwave.LightWaveReader} is the way in.
 */
package radiosity.lightwave;
