/**
 * The programs of appendix C: their options, checks, progress and exit codes.
 *
 * <p>May import every other package; no other package imports this one. A program's {@code main} only turns what
 * {@code run} returns into the exit code, so that tests call {@code run}.
 */
package radiosity.cli;
