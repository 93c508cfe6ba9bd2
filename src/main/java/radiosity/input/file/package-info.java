/**
 * Files as the readers find them: a file read once within a limit, a search by name without case, remarks to the user,
 * a budget of work.
 *
 * <p>Loads no class of {@code java.awt} or Java 3D. The objects that read one file are used by one thread.
 */
package radiosity.input.file;
