package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import radiosity.mesh.PatchTree;
import radiosity.mesh.face.NodePath;
import radiosity.protocol.Answer;
import radiosity.protocol.Shot;
import radiosity.scene.Light;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Vec3;
import radiosity.settings.RadiositySettings;
import radiosity.setup.InitialMesh;
import radiosity.testkit.Box;
import radiosity.testkit.RoomScenes;
import radiosity.util.ParallelFor;

/** What is given back of the light of a cube's floor; 0.19982 of that light leaves through the missing ceiling. */
class FluxTest {

    private static final double ESCAPES = 0.19982;

    private static InitialMesh openCube() {
        return new InitialMesh(cube().scene("open cube"), RadiositySettings.defaults());
    }

    private static SceneBuilder cube() {
        SceneBuilder builder = new SceneBuilder();
        for (int side : new int[] {0, 1, 2, 4, 5}) {
            builder.polygon(RoomScenes.grey("wall", 1, .5), Box.UNIT.inside(side));
        }
        return builder;
    }

    private static Shot floor(double radiosity) {
        double[] corners = new double[3];
        Arrays.fill(corners, radiosity);
        return new Shot(List.of(new PatchTree(4, NodePath.FACE, new int[] {-1}, corners),
                new PatchTree(5, NodePath.FACE, new int[] {-1}, corners)), radiosity);
    }

    private static double missing(double received, boolean isShotLater) {
        InitialMesh mesh = openCube();
        Flux flux = new Flux(mesh, new ParallelFor(1));
        flux.begin(List.of(floor(3), floor(-1)));
        flux.count(List.of(floor(3)));
        flux.count(List.of(floor(-1)));
        Answer answer = new Answer(mesh.faces, mesh.fluxScale());
        answer.received[0].add(received);
        return flux.missing(answer, isShotLater)[0];
    }

    @Test
    void lostFlux_isGivenBack_lessWhatEscapes() {
        assertEquals((2 * (1 - ESCAPES) - 1.2) / 1.2, missing(1.2, true), .01);
    }

    @Test
    void fluxInExcess_isTakenBack() {
        assertEquals((2 * (1 - ESCAPES) - 1.9) / 1.9, missing(1.9, true), .01);
    }

    @Test
    void fluxThatNobodyWouldShoot_isOnlyTakenBack() {
        assertEquals(0, missing(1.2, false));
        assertEquals((2 * (1 - ESCAPES) - 1.9) / 1.9, missing(1.9, false), .01);
    }

    @Test
    void lightThatTheFirstMeshDoesNotSee_isNotGivenToWhatItSees() {
        assertEquals(1, missing(.01, true));
    }

    @Test
    void fluxOfTheSky_isDoubtfulAsAWhole() {
        assertEquals(0, underSky(1.9, 0.5), 1e-12);
        double lost = 2.5 - 2 * ESCAPES - 4;
        assertEquals(lost * (1 - 1 / (lost * lost)) / 4, underSky(4, 0.5), .01);
        assertEquals(missing(1.9, true), underSky(1.9, 1e-6), 1e-3);
    }

    private static double underSky(double received, double ofTheSky) {
        InitialMesh mesh = new InitialMesh(cube().light(Light.sky(Light.Kind.SKY_UNIFORM, 1, new Vec3(0, 1, 0),
                new Vec3(0, 1, 0))).scene("open cube"), RadiositySettings.defaults());
        Flux flux = new Flux(mesh, new ParallelFor(1));
        Answer first = new Answer(mesh.faces, mesh.fluxScale());
        first.received[0].add(ofTheSky);
        flux.countLights(first);
        flux.begin(List.of(floor(2)));
        flux.count(List.of(floor(2)));
        Answer answer = new Answer(mesh.faces, mesh.fluxScale());
        answer.received[0].add(received);
        return flux.missing(answer, true)[0];
    }

    @Test
    void differenceThatMayBeNoise_isLeft() {
        assertEquals(0, missing(2 * (1 - ESCAPES), true), 1e-3);
    }
}
