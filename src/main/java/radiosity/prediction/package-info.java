/**
 * Prediction of the light that unshot light will cause, by a linear system of a coarse mesh (equation 2 of the paper):
 * rows of form factors, the Gauss-Seidel solver, and the uniform radiosity of closed rooms.
 */
package radiosity.prediction;
