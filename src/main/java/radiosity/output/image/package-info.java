/**
 * Pictures: views without a display, image formats, tone mapping, images of the scene's surfaces.
 */
package radiosity.output.image;
