package radiosity.partition;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.stream.Stream;
import radiosity.formfactor.FormFactorCalculator;
import radiosity.formfactor.FormFactorCalculators;
import radiosity.formfactor.GatherSink;
import radiosity.formfactor.RayCaster;
import radiosity.formfactor.ShooterHierarchy;
import radiosity.mesh.Block;
import radiosity.mesh.face.Faces;
import radiosity.protocol.GatherPoints;
import radiosity.protocol.Order;
import radiosity.setup.InitialMesh;
import radiosity.util.ArraySize;
import radiosity.util.ParallelFor;

/** Gathers light at those points of an estimate that are dealt to a partition's blocks, see {@link GatherPoints}. */
final class PointGatherer {

    /**
     * Light that a {@linkplain GatherPoints.Rays#COARSE coarse} ray may carry, relative to the order's tolerance. Many
     * points with coarse rays tell more of an error with a heavy tail than few points with fine rays.
     */
    private static final double COARSE = 2;
    /** The same for a {@linkplain GatherPoints.Rays#FINE fine} ray: less noise than that of the solution's rays. */
    private static final double FINE = 0.5;

    private final InitialMesh mesh;
    private final Faces faces;
    private final ParallelFor parallel;
    private final Order order;
    private final GatherPoints points;
    /** Numbers of the points of this partition's blocks, ascending. */
    private final int[] mine;

    PointGatherer(InitialMesh mesh, List<Block> blocks, Order order, GatherPoints points, ParallelFor parallel) {
        this.mesh = mesh;
        this.order = order;
        this.points = points;
        this.parallel = parallel;
        faces = mesh.faces;
        mine = points.of(blocks);
    }

    /**
     * Gathers shooter by shooter at runs of neighbouring points.
     *
     * @param shooters those of the order; not modified
     * @return for each point of the blocks: its number, 4 bytes, and its irradiance, channels x 8 bytes, W/m²
     */
    byte[] irradiance(ShooterHierarchy[] shooters) {
        int channels = faces.channels();
        FormFactorCalculator[][] calculators = calculators();
        double[] irradiance = new double[ArraySize.of("light at points of an estimate", channels, mine.length)];
        parallel.run(mine.length, Gatherer.RUN, (from, to) -> {
            GatherSink.Irradiance sum = new GatherSink.Irradiance(channels);
            for (ShooterHierarchy shooter : shooters) {
                for (int i = from; i < to; i++) {
                    System.arraycopy(irradiance, channels * i, sum.value, 0, channels);
                    gather(mine[i], calculators, shooter, sum);
                    System.arraycopy(sum.value, 0, irradiance, channels * i, channels);
                }
            }
        });
        ByteBuffer answer = ByteBuffer.allocate(ArraySize.of("bytes of light at points of an estimate", mine.length,
                Integer.BYTES + Double.BYTES * channels));
        for (int i = 0; i < mine.length; i++) {
            answer.putInt(mine[i]);
            for (int c = 0; c < channels; c++) {
                answer.putDouble(irradiance[channels * i + c]);
            }
        }
        return answer.array();
    }

    private void gather(int i, FormFactorCalculator[][] calculators, ShooterHierarchy shooter, GatherSink sum) {
        int f = points.face()[i];
        calculators[points.rays()[i]][points.slack()[i]].gather(points.place()[3 * i], points.place()[3 * i + 1],
                points.place()[3 * i + 2], faces.normal(f, 0), faces.normal(f, 1), faces.normal(f, 2),
                points.key()[i], shooter, sum);
    }

    /** One array per kind of rays, and in it one calculator per {@link GatherPoints#slack}. */
    private FormFactorCalculator[][] calculators() {
        return Stream.of(GatherPoints.Rays.values()).map(rays -> FormFactorCalculators.perSlack(
                order.rules().tolerance(), tolerance -> calculator(rays, tolerance)))
                .toArray(FormFactorCalculator[][]::new);
    }

    private FormFactorCalculator calculator(GatherPoints.Rays rays, double tolerance) {
        return switch (rays) {
            case COARSE -> RayCaster.sparing(mesh.bounds, 1, COARSE * tolerance);
            case FINE -> new RayCaster(mesh.bounds, 1, FINE * tolerance);
            case FORM_FACTORS -> FormFactorCalculators.make(mesh.settings.factors(), mesh.bounds, mesh.rays(),
                    tolerance);
        };
    }
}
