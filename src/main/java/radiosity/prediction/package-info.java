/**
 * The coarse linear system by which future light is predicted (equation 2 of the paper): rows, Gauss-Seidel, ambient
 * level.
 */
package radiosity.prediction;
