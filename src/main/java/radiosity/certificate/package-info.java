/**
 * Estimates the error of a solution by looking at it anew at independent points.
 */
package radiosity.certificate;
