/**
 * A scene that a user changes while its light follows: edits that are put on and taken off, and the worker that renders
 * what has changed, coarse at once and as exact as asked for when no further edit came.
 */
package radiosity.edit;
