/**
 * The programs: RadiosityRenderer, PartitionServer, ViewSceneFile (appendix C of the paper).
 *
 * <p>The {@code main} of a program only ends the process with the exit code of {@code run}, so that tests can call
 * {@code run}.
 */
package radiosity.cli;
