/** Reads photometric files of luminaires (IES LM-63, EULUMDAT) and replaces lights of a scene by luminaires. */
package radiosity.input.photometry;
