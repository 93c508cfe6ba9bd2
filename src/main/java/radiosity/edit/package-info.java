/**
 * Lets a user change a scene while its light follows: picking and dragging, edits and undo, saved files, and the worker
 * that renders each edit, first coarsely and, when no further edit comes, to the accuracy asked for.
 */
package radiosity.edit;
