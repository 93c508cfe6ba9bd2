/**
 * The way in for scenes of all formats: says by content, then by name, what a file is, and has it read.
 */
package radiosity.input;
