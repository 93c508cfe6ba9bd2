/**
 * A scene that a user changes while its light follows: what the mouse picks and drags, edits that are put on and taken
 * off, the worker that renders what has changed, coarse at once and as exact as asked for when no further edit came,
 * and the files that are saved.
 */
package radiosity.edit;
