/**
 * Reads luminaires' files (IES LM-63, EULUMDAT) and puts them in the place of a scene's lights.
 */
package radiosity.input.photometry;
