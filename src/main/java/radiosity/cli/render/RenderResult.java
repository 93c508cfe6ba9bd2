package radiosity.cli.render;

import java.util.Optional;
import java.util.OptionalDouble;
import radiosity.settings.RadiositySettings;
import radiosity.solution.Certificate;
import radiosity.solution.Progress;
import radiosity.solution.Solution;
import radiosity.solution.WorldStatistics;

/**
 * The result of a calculation.
 *
 * @param settings    with which the calculation began
 * @param asked       relative error that was asked for last; empty where the schedule looks at no error
 * @param patchArea   largest patch area of the initial mesh, square scene units
 * @param certificate empty where the calculation was cut
 * @param statistics  of the hosts; empty where there were none
 * @param isRounding  whether more flux is unshot than the stop rule asks for, but only by rounding
 * @param isCut       whether the calculation was stopped before its end
 */
public record RenderResult(Solution solution, RadiositySettings settings, OptionalDouble asked, Progress progress,
                  double patchArea, Optional<Certificate> certificate, Optional<WorldStatistics> statistics,
                  boolean isRounding, boolean isCut) { }
