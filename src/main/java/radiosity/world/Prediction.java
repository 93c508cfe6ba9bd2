package radiosity.world;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;

/**
 * Every patch shoots once what it will have in the end, as far as that can be foreseen, then what was foreseen wrongly.
 *
 * <p>The linear system of the initial mesh is made once; it turns unshot radiosity into the radiosity that will come of
 * it. What is shot is both together (overshooting: M. Feda, W. Purgathofer, Accelerating radiosity by overshooting,
 * 1992), so what is left after a round is small, and signed, at any reflectance. As soon as it is, the mesh is
 * subdivided where the light on it requires it.
 */
final class Prediction implements Planner {

    /** Unshot flux, relative to the emitted, at which the mesh is looked at. */
    private static final double SETTLED = 0.05;
    private static final int MOST_REFINEMENTS = 12;
    private static final double TOLERANCE = 0.05;
    private static final double MESH_ERROR = 4e-4;
    /** What the rows of the coarse system are good to: form factor that one ray may stand for. */
    private static final double ROW_TOLERANCE = 0.01;

    private final World world;
    private final CoarseSystem coarse;
    private final double tolerance;
    private final double meshError;
    /** One per channel: 1 / mean reflected radiosity. */
    private final double[] weight;
    private int refinements;
    private boolean refined;

    Prediction(World world) throws IOException {
        this.world = world;
        coarse = new CoarseSystem(world.mesh);
        RadiositySettings settings = world.settings();
        tolerance = settings.tolerance() > 0 ? settings.tolerance() : TOLERANCE;
        meshError = settings.meshError() > 0 ? settings.meshError() : MESH_ERROR;
        weight = new double[world.channels()];
        Arrays.fill(weight, 1);
        coarse.take(world.round(new Order(Order.Kind.ROWS, 0, coarse.importance(), ROW_TOLERANCE, weight, 0, 0)));
        double[] h = coarse.irradiance(coarse.exitance());
        for (int c = 0; c < weight.length; c++) {
            double mean = coarse.meanReflected(h, c);
            weight[c] = mean > 0 ? 1 / mean : 0;
        }
    }

    @Override
    public Order next(Answer last, int shots) throws IOException {
        Answer answer = last;
        while (shots > 0 && !refined && unsent(answer) <= SETTLED) {
            answer = refine(answer);
        }
        double[] unshot = coarse.noUnshot();
        answer.candidates.forEach(shot -> coarse.restrict(shot, unshot));
        double[] h = coarse.irradiance(unshot);
        List<Shot> predicted = answer.candidates.stream().map(shot -> coarse.with(shot, h)).toList();
        return new Order(Order.Kind.SHOOT, 0, predicted, tolerance, weight, 0, Integer.MAX_VALUE);
    }

    private double unsent(Answer answer) {
        double emitted = world.mesh.totalEmitted();
        return emitted == 0 ? 0 : answer.unshotFlux.value() / emitted;
    }

    private Answer refine(Answer before) throws IOException {
        List<Shot> totals = world.totals();
        refinements++;
        Answer after = world.answer(new Order(Order.Kind.REFINE, refinements, totals, tolerance, weight, meshError,
                Integer.MAX_VALUE));
        refined = after.elements == before.elements || refinements == MOST_REFINEMENTS;
        return after;
    }

    @Override
    public boolean isEnough(double unsent, double wanted) {
        return refined && unsent <= wanted;
    }

    @Override
    public void write(DataOutput out) throws IOException {
        out.writeInt(refinements);
        out.writeBoolean(refined);
    }

    @Override
    public void read(DataInput in) throws IOException {
        refinements = in.readInt();
        refined = in.readBoolean();
    }
}
