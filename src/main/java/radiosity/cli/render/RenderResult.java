package radiosity.cli.render;

import java.util.Optional;
import java.util.OptionalDouble;
import radiosity.settings.RadiositySettings;
import radiosity.solution.Certificate;
import radiosity.solution.Progress;
import radiosity.solution.Solution;
import radiosity.solution.WorldStatistics;

/**
 * What a calculation came to.
 *
 * @param settings    with which it was begun
 * @param asked       relative error that it was to have in the end, where one was asked for
 * @param patchArea   largest of the first mesh, square scene units
 * @param certificate of a calculation that was not cut
 * @param statistics  of its hosts, where there were any
 * @param isRounding  whether what is unsent is more than was asked for, but only rounding
 * @param isCut       whether it was stopped before it was done
 */
public record RenderResult(Solution solution, RadiositySettings settings, OptionalDouble asked, Progress progress,
                  double patchArea, Optional<Certificate> certificate, Optional<WorldStatistics> statistics,
                  boolean isRounding, boolean isCut) { }
