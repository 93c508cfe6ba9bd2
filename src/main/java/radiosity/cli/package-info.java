/**
 * The programs: RadiosityRenderer, PartitionServer, ViewSceneFile (appendix C of the paper).
 *
 * <p>A program's {@code main} only turns what {@code run} returns into the exit code, so that tests call {@code run}.
 */
package radiosity.cli;
