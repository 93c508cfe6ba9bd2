/**
 * World set-up (section 4.2 of the paper): data that follow from scene and settings alone, the same on every host.
 */
package radiosity.setup;
