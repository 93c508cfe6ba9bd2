package radiosity.edit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import radiosity.scene.Affine;
import radiosity.scene.Hierarchy;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneNode;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/** A change that a user makes to a scene: an object is moved or turned, or a surface is painted. */
public sealed interface Edit {

    /**
     * Returns the scene after this edit.
     *
     * @throws IllegalArgumentException where the scene has no such object or surface, or the edit is impossible there
     */
    Scene of(Scene scene);

    /** Describes this edit to the user in a few words. */
    String text(Scene scene);

    /**
     * An object, with its child objects, is turned about a vertical axis and then moved.
     *
     * @param node  number of the object in the scene's hierarchy
     * @param about point on the vertical axis, scene units
     * @param turn  radians, anticlockwise seen from above
     * @param by    displacement after the turn, scene units
     */
    record Moved(int node, Vec3 about, double turn, Vec3 by) implements Edit {

        /** Maps points of the object from the old to the new position, scene units. */
        public Affine map() {
            double c = StrictMath.cos(turn);
            double s = StrictMath.sin(turn);
            Affine turned = new Affine(new double[] {c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0});
            return turn == 0 ? Affine.move(by.x(), by.y(), by.z())
                    : Affine.move(about.x() + by.x(), about.y() + by.y(), about.z() + by.z()).times(turned)
                    .times(Affine.move(-about.x(), -about.y(), -about.z()));
        }

        @Override
        public Scene of(Scene scene) {
            boolean[] moved = ObjectTriangles.triangles(scene, node);
            Affine map = map();
            int count = scene.points().length / 3;
            boolean[] isMoved = new boolean[count];
            boolean[] stays = new boolean[count];
            for (int i = 0; i < scene.corners().length; i++) {
                (moved[i / 3] ? isMoved : stays)[scene.corners()[i]] = true;
            }
            double[] points = Arrays.copyOf(scene.points(), 2 * scene.points().length);
            int[] place = new int[count];
            int all = count;
            for (int p = 0; p < count; p++) {
                place[p] = !isMoved[p] || !stays[p] ? p : all++;
                for (int a = 0; a < 3 && isMoved[p]; a++) {
                    points[3 * place[p] + a] = map.point(a, scene.points()[3 * p], scene.points()[3 * p + 1],
                            scene.points()[3 * p + 2]);
                }
            }
            int[] corners = scene.corners().clone();
            for (int i = 0; i < corners.length; i++) {
                corners[i] = moved[i / 3] ? place[corners[i]] : corners[i];
            }
            return new Scene(scene.name(), Arrays.copyOf(points, 3 * all), corners, scene.surfaceOf(),
                    scene.surfaces(), scene.lights(), scene.camera(), scene.textureCoordinates(),
                    scene.vertexColours(), hierarchy(scene.hierarchy(), map), scene.units());
        }

        /** Returns the hierarchy with the object's node at the new position, too. */
        private Hierarchy hierarchy(Hierarchy before, Affine map) {
            List<SceneNode> nodes = new ArrayList<>(before.nodes());
            SceneNode of = nodes.get(node);
            Affine parent = ObjectTriangles.place(before, of.parent());
            nodes.set(node, new SceneNode(of.name(), of.parent(), of.geometry(),
                    parent.inverse().times(map).times(parent).times(of.placement())));
            return new Hierarchy(nodes, before.nodeOf());
        }

        @Override
        public String text(Scene scene) {
            return String.format(Locale.ROOT, "%s moved by %.4g  %.4g  %.4g%s",
                    scene.hierarchy().nodes().get(node).name(), by.x(), by.y(), by.z(), turn == 0 ? ""
                    : String.format(Locale.ROOT, ", turned by %.0f degrees", Math.toDegrees(turn)));
        }
    }

    /**
     * A surface gets another reflectance, on all its triangles. Channels are rounded to floats, which is what files
     * hold.
     *
     * @param surface     index among the scene's surfaces
     * @param reflectance rho, each channel in [0, {@value Surface#MAX_REFLECTANCE}]
     */
    record Painted(int surface, Rgb reflectance) implements Edit {

        public Painted {
            reflectance = new Rgb((float) reflectance.r(), (float) reflectance.g(), (float) reflectance.b());
        }

        @Override
        public Scene of(Scene scene) {
            Surface of = scene.surfaces().get(surface);
            if (of.maps().reflectance().isPresent()) {
                throw new IllegalArgumentException(of.name() + ": expected a surface of one colour, got an image");
            }
            List<Surface> surfaces = new ArrayList<>(scene.surfaces());
            surfaces.set(surface, new Surface(of.name(), of.exitance(), reflectance, of.twoSided(), of.textures(),
                    of.maps(), of.specular(), of.smoothing()));
            return scene.with(surfaces, scene.lights());
        }

        @Override
        public String text(Scene scene) {
            return String.format(Locale.ROOT, "%s reflects %.3g  %.3g  %.3g", scene.surfaces().get(surface).name(),
                    reflectance.r(), reflectance.g(), reflectance.b());
        }
    }
}
