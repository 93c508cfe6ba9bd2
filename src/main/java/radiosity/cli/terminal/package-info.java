/**
 * Progress, keys and streams of a terminal.
 */
package radiosity.cli.terminal;
