/** One render from options to files: journal, stopping and resuming, summary. */
package radiosity.cli.render;
