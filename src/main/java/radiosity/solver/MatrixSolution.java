package radiosity.solver;

import java.io.IOException;
import java.util.List;
import java.util.function.BooleanSupplier;
import radiosity.prediction.CoarseSystem;
import radiosity.protocol.Answer;
import radiosity.protocol.Order;
import radiosity.protocol.Shot;

/**
 * The whole linear system (equation 2 and section 2.1 of the paper), solved by Gauss-Seidel, for small scenes.
 *
 * <p>The rows of the system are made once. Then every patch shoots its final radiosity, in rounds until nothing but
 * rounding is unshot: {@link Prediction} with the mesh itself as the coarse mesh.
 */
final class MatrixSolution implements Planner {

    private final CoarseSystem system;
    private final Order.Rules rules;

    MatrixSolution(World world) {
        system = new CoarseSystem(world.mesh, world.parallel);
        rules = Order.Rules.exact(world.channels());
    }

    @Override
    public Order next(Answer last, double unsent, BooleanSupplier goOn) {
        if (last.candidates.isEmpty()) {
            return null;
        }
        if (!system.isMade()) {
            return order(Order.Kind.ROWS, system.importance());
        }
        double[] h = system.irradiance(system.restrict(last.candidates), goOn);
        return h == null ? null
                : order(Order.Kind.SHOOT, system.with(last.candidates, h, false));
    }

    private Order order(Order.Kind kind, List<Shot> shots) {
        return new Order(kind, shots, rules, Order.Question.candidates(Integer.MAX_VALUE));
    }

    @Override
    public void take(int shots, List<byte[]> rows) throws IOException {
        system.take(shots, rows);
    }
}
