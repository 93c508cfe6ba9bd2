/**
 * World set-up (section 4.2 of the paper): what follows from scene and settings alone, the same on every host.
 */
package radiosity.setup;
