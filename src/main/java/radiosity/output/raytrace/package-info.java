/**
 * The second pass over a diffuse solution: light along rays from the eye through mirrors and glass, and light gathered
 * anew at a point.
 */
package radiosity.output.raytrace;
