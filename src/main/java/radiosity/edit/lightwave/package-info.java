/** Edits saved in a copy of the LightWave scene that they were made on. */
package radiosity.edit.lightwave;
