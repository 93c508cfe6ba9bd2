/**
 * Files written whole or not at all.
 *
 * <p>A file is replaced as a whole or not at all.
 */
package radiosity.output.file;
