/**
 * The second pass over a diffuse solution: what the eye sees along a ray through mirrors and glass, and the light at a
 * point gathered anew.
 */
package radiosity.output.raytrace;
