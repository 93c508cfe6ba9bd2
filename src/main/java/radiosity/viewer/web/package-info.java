/** The page on which the user walks through a scene in a browser. */
package radiosity.viewer.web;
