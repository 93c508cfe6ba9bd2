/**
 * Settings that a user chooses: how files are read, accuracy, schedule, kind of form factors, when to stop.
 */
package radiosity.settings;
