/**
 * The command lines of the programs: options, their values, messages, exit codes.
 */
package radiosity.cli.options;
