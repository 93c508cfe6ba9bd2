/**
 * What leaves the program (section 4.6 and appendix C.1 of the paper): the scene file, pictures, values at points.
 *
 * <p>Imports {@code scene}, {@code visibility} and {@code world}. Everything here starts from a
 * {@link radiosity.world.Solution} and changes nothing in it; a file is replaced as a whole or not at all.
 */
package radiosity.output;
