/** Saves edits in a copy of the LightWave scene on which they were made. */
package radiosity.edit.lightwave;
