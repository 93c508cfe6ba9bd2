/**
 * What a user may ask of a calculation: accuracy, schedule, kind of form factors, when to stop.
 */
package radiosity.settings;
