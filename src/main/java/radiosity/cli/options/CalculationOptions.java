package radiosity.cli.options;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import picocli.CommandLine.Option;
import radiosity.scene.Scene;
import radiosity.settings.Accuracy;
import radiosity.settings.FormFactors;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;

/** Options for the accuracy of the calculation and for when to stop. */
public final class CalculationOptions {

    @Option(names = {"-pa", "--patch-area"}, paramLabel = "<n>", converter = PatchArea.Parser.class,
            description = "Maximal patch area: larger triangles are subdivided. In square scene units, or n%% of the"
                    + " area of the scene. Chosen from the scene without it.")
    PatchArea patchArea;

    @Option(names = {"-nr", "--rays"}, paramLabel = "<n>", converter = Values.Rays.class,
            description = "Number of rays that the ray caster uses. Chosen by the schedule without it.")
    public Integer rays;

    @Option(names = {"-mt", "--meshing-threshold"}, paramLabel = "<n>", converter = Values.NotNegative.class,
            description = "Adaptive meshing: a triangle whose vertices differ by more than this in radiosity (W/m2,"
                    + " lm/m2) is subdivided, up to four times. Without it never with a schedule of the paper; by"
                    + " default the error asked for tells what is subdivided.")
    Double meshing;

    @Option(names = {"-it", "--iterations"}, paramLabel = "<n>", converter = Values.Count.class,
            description = "Stop after n iterations (shots).")
    Integer iterations;

    @Option(names = {"-se", "--stop-error"}, paramLabel = "<n>", converter = Values.Part.class,
            description = "Stop when n [0:1] of the emitted light is not yet distributed. Default: "
                    + StopRule.DEFAULT_UNSENT + ".")
    Double unsent;

    @Option(names = TimeLimit.ESTIMATES, paramLabel = "<n>", converter = Values.AtLeastOne.class,
            description = "Stop after n estimates of the error; each is followed by a finer mesh or more rays. With"
                    + " --schedule predict.")
    Integer estimates;

    @Option(names = "--schedule", paramLabel = "<order>", converter = ScheduleParser.class,
            description = "Which patches shoot when: paper (most undistributed light first) or predict; for small"
                    + " scenes also shooting (each in turn), gathering or matrix. -it and -se alone select paper.")
    Schedule schedule;

    @Option(names = "--accuracy", paramLabel = "<n>%", converter = Values.PerCent.class, split = ",",
            description = "Expected error of the radiosity, of its mean. Default: 2%%. With several, as 10%%,2%%, the"
                    + " later ones go on from the first; with -tf, from that of the file. With --schedule predict.")
    List<Double> accuracy;

    @Option(names = TimeLimit.OPTION, paramLabel = "<n>s", converter = TimeLimit.Parser.class,
            description = "Wall time of the whole render, like 60s, 500ms or 2m: the best accuracy that can be had in"
                    + " it, and at the end the options that give the same. With --schedule predict.")
    public TimeLimit time;

    @Option(names = "--form-factors", paramLabel = "<kind>", converter = FormFactorsParser.class,
            description = "How form factors are found: raycast, plain (the paper's rays), hemicube or nusselt. With the"
                    + " last two -nr is the number of cells along an edge.")
    FormFactors factors;

    @Option(names = "--layers",
            description = "Keep the light of each lamp (a surface that emits, a light) apart, so "
                    + "that lamps can be dimmed"
                    + " and coloured in the viewer.")
    boolean layers;

    @Option(names = {"-t", "--threads"}, paramLabel = "<n>", converter = Values.AtLeastOne.class,
            description = "Number of threads. Default: one per processor.")
    public int threads = Runtime.getRuntime().availableProcessors();

    /**
     * The largest area of a patch as the user gives it ({@code -pa}).
     *
     * @param amount   above 0; square scene units, or per cent of the area of the scene
     * @param relative whether the amount is in per cent
     */
    record PatchArea(double amount, boolean relative) {

        /** The largest area of a patch in a scene, square scene units. */
        double in(Scene scene) {
            return relative ? amount / 100 * scene.area() : amount;
        }

        /** Parses {@code 1000} and {@code 0.5%}. */
        static final class Parser extends Values.Value<PatchArea> {
            @Override
            String expected() {
                return "a number above 0";
            }

            @Override
            public PatchArea parse(String text) {
                boolean relative = text.endsWith("%");
                double amount = Values.decimal(relative ? text.substring(0, text.length() - 1) : text);
                return amount > 0 && !(relative && amount > 100) ? new PatchArea(amount, relative) : null;
            }
        }
    }

    /** Parses the name of a kind of form factors. */
    public static final class FormFactorsParser extends Values.Choice<FormFactors> {
        public FormFactorsParser() {
            super(FormFactors.class);
        }
    }

    /** Parses the name of a schedule. */
    public static final class ScheduleParser extends Values.Choice<Schedule> {
        public ScheduleParser() {
            super(Schedule.class);
        }
    }

    /** Checks what depends neither on the scene nor on a saved calculation: before the scene is read. */
    void check() {
        checkFalls();
        defaults();
        if (schedule != null) {
            check(schedule);
        }
    }

    private void check(Schedule asked) {
        String option = accuracy != null ? "--accuracy" : time != null ? TimeLimit.OPTION : TimeLimit.ESTIMATES;
        if ((accuracy != null || time != null || estimates != null) && asked != Schedule.PREDICT) {
            throw Failure.commandLine(option,
                    "expected --schedule predict, got " + asked.name().toLowerCase(Locale.ROOT));
        }
    }

    /** @param otherwise settings that apply where an option is not given */
    public RadiositySettings settings(Scene scene, RadiositySettings otherwise) {
        RadiositySettings asked = new RadiositySettings(patchArea == null ? otherwise.patchArea() : patchArea.in(scene),
                rays == null ? otherwise.rays() : rays, meshing == null ? otherwise.meshing() : meshing,
                schedule == null ? otherwise.schedule() : schedule, otherwise.tolerance(), otherwise.meshError(),
                layers || otherwise.layers(), factors == null ? otherwise.factors() : factors);
        check(asked.schedule());
        return accuracy == null ? asked : asked.accurate(accuracy.get(0));
    }

    /** The settings where no option is given, but for one: a stop rule of the paper selects the paper's schedule. */
    public RadiositySettings defaults() {
        RadiositySettings defaults = RadiositySettings.defaults();
        boolean papers = iterations != null || unsent != null;
        if (papers && schedule == null && (accuracy != null || time != null)) {
            throw Failure.commandLine(iterations != null ? "-it" : "-se", "expected --schedule predict with "
                    + (accuracy != null ? "--accuracy" : TimeLimit.OPTION) + ", got no --schedule");
        }
        return new RadiositySettings(defaults.patchArea(), defaults.rays(), defaults.meshing(),
                papers ? Schedule.PAPER : defaults.schedule());
    }

    /** Relative error with which the calculation ends; NaN where it ends by another criterion. */
    public double lastAccuracy() {
        return accuracy != null ? accuracy.get(accuracy.size() - 1)
                : defaults().schedule() == Schedule.PREDICT && schedule == null ? Accuracy.DEFAULT : Double.NaN;
    }

    private void checkFalls() {
        for (int i = 1; accuracy != null && i < accuracy.size(); i++) {
            if (accuracy.get(i) >= accuracy.get(i - 1)) {
                throw Failure.commandLine("--accuracy", "expected each smaller than the one before, like 10%,2%, got "
                        + accuracy.stream().map(TimeLimit::perCent).collect(Collectors.joining(",")));
            }
        }
    }

    /** Relative errors to reach after the one for which the settings are made, in their order. */
    public List<Double> aims(RadiositySettings settings) {
        return accuracy == null ? List.of() : accuracy.stream().filter(settings::isCoarserThan).toList();
    }

    /** Whether only the accuracy asked for ends the calculation. */
    public boolean isAccuracyAsked() {
        return accuracy != null && iterations == null && unsent == null && estimates == null && time == null;
    }

    public StopRule stopRule() {
        return new StopRule(iterations == null ? Integer.MAX_VALUE : iterations,
                unsent != null ? unsent : StopRule.DEFAULT_UNSENT, estimates == null ? Integer.MAX_VALUE : estimates);
    }
}
