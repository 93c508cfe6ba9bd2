package radiosity.cli.render;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import radiosity.cli.options.ErrorReport;
import radiosity.cli.options.Failure;
import radiosity.cli.options.TimeLimit;
import radiosity.cli.options.Values;
import radiosity.cli.terminal.StopRequest;
import radiosity.cli.terminal.TimeCourse;
import radiosity.master.host.NoWorkerException;
import radiosity.settings.RadiositySettings;
import radiosity.solution.Certificate;
import radiosity.solver.ProgressiveRadiosity;

/**
 * Calculates ever more exactly until a time limit ({@code --time}); the result is the last solution whose error was
 * estimated.
 *
 * <p>Time decides which accuracies are asked for and after which estimate of the error the calculation ends, never the
 * bits of a solution: each solution is the one that {@code --accuracy} and {@code --estimates} give with the values
 * that the scene file names. Each solution is saved as soon as its error is estimated; if that fails, the user gets a
 * message, the calculation goes on, and {@link #save} tries again at the end. A later solution has a finer mesh or more
 * rays, so it counts even if its estimate, which is uncertain, is a little larger. If the error is not estimated even
 * once in time, the calculation is cut off after a shot, as by {@code -it}.
 */
public final class TimedCalculation implements RenderJob.Aims {

    /** Part of the time limit that is reserved for writing the outputs. */
    private static final double RESERVE = 0.03;
    /** Before the first estimate it goes on beyond the limit until at most this part of the emitted flux is unshot. */
    private static final double LIT = 0.5;

    private final RenderJob calculation;
    private final RadiositySettings settings;
    private final TimeLimit limit;
    private final TimeCourse course;
    private final AccuracyChoice choice = new AccuracyChoice(Runtime.getRuntime().maxMemory());
    private final ConsoleSession user;
    private final StopRequest stop;
    private final OutputFiles files;

    /** The current calculation. */
    private ProgressiveRadiosity current;
    /** Number of shots at the last check. */
    private int shots;
    /** Whether the limit has cut off the calculation before the first estimate. */
    private boolean isCutOff;
    /** Whether the user has got the message that the first estimate comes later than the limit. */
    private boolean isLate;
    /** The last solution whose error was estimated; null before there is one. */
    private RenderResult kept;
    /** Whether the scene file holds that solution. */
    private boolean isSaved;
    /** The options that reproduce that solution. */
    private List<String> options = List.of();
    /** The accuracies asked for so far, as the user would write them; the last is being calculated. */
    private final List<String> accuracies = new ArrayList<>();
    /** The relative error asked for; 100 times the error may have more digits than the text. */
    private double aim;
    /** Time left before the first shot, s. */
    private double begin;

    public TimedCalculation(RenderJob calculation, RadiositySettings settings, TimeLimit limit, TimeCourse course,
                     ConsoleSession user, StopRequest stop, OutputFiles files) {
        this.calculation = calculation;
        this.settings = settings;
        this.limit = limit;
        this.course = course;
        this.user = user;
        this.stop = stop;
        this.files = files;
    }

    /**
     * Calculates until the limit, or beyond it until half of the light is distributed; {@link #save} saves the result.
     *
     * @return the last solution whose error was estimated, or the first one as far as it got
     */
    public RenderResult run() throws IOException {
        aim(AccuracyChoice.COARSEST);
        try {
            RenderResult last = calculation.run(settings.accurate(aim),
                    radiosity -> current = radiosity, this, Optional.empty(), this::goesOn);
            if (last.isCut() && kept == null) {
                keep(last, isCutOff ? TimeLimit.cutOff(text(), last.progress().shots()) : TimeLimit.accuracy(text()));
            } else if (last != kept) {
                keep(last, TimeLimit.accuracy(text()));
            }
        } catch (NoWorkerException | OutOfMemoryError e) {
            if (kept == null) {
                throw e;
            }
            user.message(accuracies.get(accuracies.size() - 1) + ": " + ErrorReport.line(e));
        }
        return kept;
    }

    private void aim(double error) {
        String perCent = TimeLimit.perCent(error);
        accuracies.add(perCent);
        aim = new Values.PerCent().convert(perCent);
        course.at(perCent);
    }

    /** Keeps a solution that is as exact as was asked for, and chooses the next relative error; empty for none. */
    @Override
    public OptionalDouble after(RenderResult result) throws IOException {
        keep(result, TimeLimit.accuracy(text()));
        saveEarly();
        choice.reached(Math.min(aim, error(result)), begin - course.left(), result.progress().elements());
        double next = choice.next(left());
        if (next == 0) {
            return OptionalDouble.empty();
        }
        aim(next);
        return OptionalDouble.of(aim);
    }

    /** Keeps a solution on the way to the accuracy asked for, unless it is the one that the way began with. */
    @Override
    public void estimated(RenderJob.Estimated solution) throws IOException {
        if (kept == null || current.progress().rounds() > kept.progress().rounds()) {
            keep(solution.result(), TimeLimit.estimates(text(), current.estimates()));
            saveEarly();
        }
    }

    private static double error(RenderResult result) {
        return result.certificate().map(Certificate::expected).orElse(Double.POSITIVE_INFINITY);
    }

    private void keep(RenderResult result, List<String> same) {
        kept = result;
        options = same;
        isSaved = false;
    }

    /** Saves a solution that a better one may follow; a failure gives a message and does not end the calculation. */
    private void saveEarly() {
        try {
            save();
        } catch (Failure | IOException | OutOfMemoryError e) {
            user.message(ErrorReport.line(e));
        }
    }

    /**
     * Saves the result in the scene file, unless the scene file holds the result already.
     *
     * @throws Failure where the scene file cannot be written
     */
    public void save() throws IOException {
        if (!isSaved) {
            files.reproducedBy(options).saveScene(kept.solution(), kept.settings(), kept.certificate());
            isSaved = true;
        }
    }

    @Override
    public Optional<RenderResult> kept() {
        return Optional.ofNullable(kept);
    }

    /** The value of {@code --accuracy} of the calculation so far. */
    private String text() {
        return String.join(",", accuracies);
    }

    private double left() {
        return course.left() - RESERVE * limit.seconds();
    }

    /** Cuts off right after a step that has shot, never after one that divides or gathers: {@code -it} ends there. */
    private boolean goesOn() {
        int before = shots;
        shots = current == null ? 0 : current.shots();
        if (shots == 0) {
            begin = course.left(); // setting up takes time once
        }
        if (stop.made() || left() > 0) {
            return !stop.made();
        }
        isCutOff = kept == null && shots > before && current.progress().unsent() <= LIT;
        if (kept == null && !isCutOff && !isLate) {
            isLate = true;
            user.message(TimeLimit.OPTION + " " + limit.text()
                    + ": too short for this scene; going on until half of its light is distributed");
        }
        return kept == null && !isCutOff;
    }

    /** A line for the user: the time of the calculation, and the options that reproduce it to the last bit. */
    public String summary() {
        String time = String.format(Locale.ROOT, "%.3g s", limit.seconds() - course.left());
        String same = String.join(" ", options);
        if (isCutOff) {
            return TimeLimit.OPTION + " " + limit.text() + ": too short for this scene, cut off after " + time
                    + "; the same as with " + same;
        }
        return TimeLimit.OPTION + " " + limit.text() + ": "
                + (kept.isCut() ? "stopped after " + time + " in the first calculation, the one of " + same
                : (stop.made() ? "stopped after " : "done in ") + time + "; the same as with " + same);
    }
}
