/**
 * Files that are written whole or not at all, and files that their process holds locked.
 */
package radiosity.output.file;
