/** Estimates the error of a solution by gathering its light anew at independent points. */
package radiosity.certificate;
