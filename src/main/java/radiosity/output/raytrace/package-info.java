/**
 * The second pass over a diffuse solution: rays from the eye through mirrors and glass, and light gathered at a point.
 */
package radiosity.output.raytrace;
