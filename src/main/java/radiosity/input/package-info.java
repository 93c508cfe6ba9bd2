/** The way in for scenes of all formats: recognises a file's format by content, then by name, and has the file read. */
package radiosity.input;
