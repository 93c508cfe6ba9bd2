/**
 * The light at points that the user names.
 */
package radiosity.output.points;
