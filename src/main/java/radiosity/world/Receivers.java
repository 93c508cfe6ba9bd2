package radiosity.world;

import java.util.Arrays;
import radiosity.formfactor.FormFactorCalculator;
import radiosity.formfactor.Gathering;
import radiosity.formfactor.Shooter;
import radiosity.patch.Ambient;
import radiosity.patch.Faces;
import radiosity.patch.Patcher;
import radiosity.patch.RadiosityNodes;
import radiosity.patch.Weights;

/** How the vertices of a mesh receive what an order lets shoot. */
final class Receivers {

    /** Vertices that a thread takes at a time. */
    static final int RUN = 64;

    private final InitialMesh mesh;
    private final Faces faces;
    private final Crew crew;
    private final Burial burial;

    Receivers(InitialMesh mesh, Crew crew) {
        this.mesh = mesh;
        this.crew = crew;
        faces = mesh.faces;
        burial = new Burial(faces, mesh.bounds(), mesh.rooms::isHidden);
    }

    /** Marks which vertices lie inside a solid, from the first on that has not been looked at. */
    void bury(RadiosityNodes nodes, int first) {
        crew.run(nodes.vertices() - first, RUN, (from, to) -> burial.look(nodes, first + from, first + to));
    }

    /** The same for some vertices. */
    void bury(RadiosityNodes nodes, int[] vertices) {
        crew.run(vertices.length, i -> burial.look(nodes, vertices[i], vertices[i] + 1));
    }

    Ambient ambient(Order order) {
        return new Ambient(mesh.rooms, faces.channels(), order.ambient());
    }

    Weights weights(Order order) {
        return new Weights(mesh.rooms, faces.channels(), order.weight());
    }

    Shooter[] shooters(Order order) {
        Ambient ambient = ambient(order);
        Weights weights = weights(order);
        Shooter[] made = new Shooter[order.shots().size()];
        crew.run(made.length, i -> made[i] = order.shots().get(i).shooter(faces, weights, ambient));
        return made;
    }

    /** One per {@link Patcher#slack}. */
    FormFactorCalculator[] calculators(Order order) {
        FormFactorCalculator[] made = new FormFactorCalculator[Patcher.MOST_SLACK + 1];
        Arrays.setAll(made, slack -> mesh.settings.factors().calculator(mesh.bounds(), mesh.rays(),
                order.tolerance() * (1 << slack)));
        return made;
    }

    /** What one vertex receives of one shooter. */
    void gather(FormFactorCalculator calculator, Shooter shooter, RadiosityNodes nodes, int v, Gathering sum) {
        float[] x = nodes.receivers();
        int f = faces.plane(nodes.vertexFace(v));
        calculator.gather(x[3 * v], x[3 * v + 1], x[3 * v + 2],
                faces.normal(f, 0), faces.normal(f, 1), faces.normal(f, 2), nodes.vertexKey(v), shooter, sum);
    }
}
