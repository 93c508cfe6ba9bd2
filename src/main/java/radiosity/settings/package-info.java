/**
 * What a user may ask for: how files are read, accuracy, schedule, kind of form factors, when to stop.
 */
package radiosity.settings;
