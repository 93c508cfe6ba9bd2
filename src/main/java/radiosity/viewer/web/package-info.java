/**
 * The page in which one walks through a scene, in a browser.
 */
package radiosity.viewer.web;
