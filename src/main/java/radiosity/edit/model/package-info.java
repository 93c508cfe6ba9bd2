/** Saves edits in a copy of the model on which they were made: a LightWave scene or a glTF file. */
package radiosity.edit.model;
