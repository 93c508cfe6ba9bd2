package radiosity.testkit;

import java.io.IOException;
import java.io.UncheckedIOException;
import radiosity.scene.Scene;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;
import radiosity.settings.StopRule;
import radiosity.solution.Certificate;
import radiosity.solution.Solution;
import radiosity.solver.LocalWorld;
import radiosity.solver.ProgressiveRadiosity;

/**
 * One way to have a scene solved.
 *
 * @param settings how finely and how exactly
 * @param stop     when to stop
 * @param threads  at least 1
 */
public record Solve(RadiositySettings settings, StopRule stop, int threads) {

    /** What a user gets who gives no option. */
    public static Solve byDefault() {
        return new Solve(RadiositySettings.defaults(), new StopRule(Integer.MAX_VALUE, StopRule.DEFAULT_UNSENT), 2);
    }

    /** With no more than this part of the emitted flux left unshot. */
    public Solve unsent(double part) {
        return new Solve(settings, new StopRule(stop.shots(), part), threads);
    }

    /** With this expected error, see {@link RadiositySettings#accurate}. */
    public Solve accurate(double error) {
        return settings(settings.accurate(error));
    }

    public Solve threads(int count) {
        return new Solve(settings, stop, count);
    }

    /** With an initial mesh of about so many patches. */
    public Solve patches(Scene scene, int count) {
        RadiositySettings s = settings;
        return settings(new RadiositySettings(scene.area() / count, s.rays(), s.meshing(), s.schedule(), s.tolerance(),
                s.meshError(), s.layers(), s.factors()));
    }

    /** With rays that carry no more than this part of the mean light each. */
    public Solve tolerance(double part) {
        RadiositySettings s = settings;
        return settings(new RadiositySettings(s.patchArea(), s.rays(), s.meshing(), s.schedule(), part, s.meshError()));
    }

    /** By shooting and sorting, as the paper has it. */
    public Solve paper() {
        RadiositySettings s = settings;
        return settings(new RadiositySettings(s.patchArea(), s.rays(), s.meshing(), Schedule.PAPER));
    }

    public Solve settings(RadiositySettings other) {
        return new Solve(other, stop, threads);
    }

    public Solution solution(Scene scene) {
        return certified(scene, false).solution();
    }

    /**
     * A solution and how far it says it can be trusted.
     *
     * @param certificate null where it was not asked for
     */
    public record Certified(Solution solution, Certificate certificate) { }

    public Certified certified(Scene scene, boolean certificate) {
        try (LocalWorld world = new LocalWorld(scene, settings, threads)) {
            ProgressiveRadiosity rounds = new ProgressiveRadiosity(world, stop);
            rounds.run(progress -> true);
            return new Certified(rounds.solution(), certificate ? rounds.certificate(threads).orElseThrow() : null);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
