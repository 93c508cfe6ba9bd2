package radiosity.testkit;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import radiosity.accuracy.FormFactorsTest;
import radiosity.formfactor.FormFactorCalculator;
import radiosity.formfactor.FormFactorCalculators;
import radiosity.formfactor.GatherSink;
import radiosity.formfactor.ShooterHierarchy;
import radiosity.mesh.PatchTree;
import radiosity.mesh.Weights;
import radiosity.mesh.face.Faces;
import radiosity.mesh.face.NodePath;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.FormFactors;
import radiosity.visibility.RadiosityBounds;

/** Form factors to a polygon as a {@link FormFactorCalculator} finds them: what arrives of a radiosity of 1. */
public final class Calculated {

    private static final Surface LAMP = new Surface("to", Rgb.grey(1), Rgb.BLACK, false);
    private static final Surface BLACK = new Surface("other", Rgb.BLACK, Rgb.BLACK, false);
    /** The R2 sequence's steps. */
    private static final double STEP_U = 0.7548776662466927;
    private static final double STEP_V = 0.5698402909980532;

    private final Faces faces;
    private final List<ShooterHierarchy> shooters = new ArrayList<>();
    private final RadiosityBounds bounds;

    /** @param others polygons that are in the scene too; they block light */
    public Calculated(Vec3[] to, List<Vec3[]> others) {
        SceneBuilder builder = new SceneBuilder().polygon(LAMP, to);
        others.forEach(other -> builder.polygon(BLACK, other));
        Scene scene = builder.scene("form factor");
        faces = new Faces(scene);
        bounds = new RadiosityBounds(faces.occluders());
        for (int f = 0; f < faces.count(); f++) {
            if (faces.exitance(f, 0) > 0) {
                PatchTree tree = new PatchTree(f, NodePath.FACE, new int[] {-1}, new double[] {1, 1, 1});
                shooters.add(new ShooterHierarchy(faces, List.of(tree), Weights.of(new double[] {1})));
            }
        }
    }

    /** A case of {@code formfactors.json}. */
    public static Calculated of(JsonNode c) {
        List<Vec3[]> others = new ArrayList<>();
        if (c.has("blockers")) {
            c.get("blockers").forEach(blocker -> others.add(SharedData.polygon(blocker)));
        }
        if (c.has("polygon1")) {
            others.add(SharedData.polygon(c.get("polygon1")));
        }
        return new Calculated(SharedData.polygon(c.get("polygon2")), others);
    }

    /** From a point. */
    public double from(FormFactorCalculator calculator, Vec3 point, Vec3 normal, long key) {
        Vec3 p = faces.unit(point);
        Vec3 n = normal.unit();
        GatherSink.Irradiance sum = new GatherSink.Irradiance(1);
        for (ShooterHierarchy shooter : shooters) {
            calculator.gather((float) p.x(), (float) p.y(), (float) p.z(), (float) n.x(), (float) n.y(), (float) n.z(),
                    key, shooter, sum);
        }
        return sum.value[0];
    }

    /** Mean over points of a polygon. */
    public double from(FormFactorCalculator calculator, Vec3[] polygon, int points) {
        Vec3 normal = FormFactorsTest.normal(polygon);
        double area = Quadrature.area(Arrays.asList(polygon));
        double sum = 0;
        for (int i = 2; i < polygon.length; i++) {
            Vec3 a = polygon[0];
            Vec3 ab = polygon[i - 1].minus(a);
            Vec3 ac = polygon[i].minus(a);
            double share = ab.cross(ac).length() / 2 / area;
            for (int k = 1; k <= points; k++) {
                double u = k * STEP_U % 1;
                double v = k * STEP_V % 1;
                boolean fold = u + v > 1;
                Vec3 p = a.plus(ab.times(fold ? 1 - u : u)).plus(ac.times(fold ? 1 - v : v));
                sum += share / points * from(calculator, p, normal, 1000L * i + k);
            }
        }
        return sum;
    }

    public FormFactorCalculator calculator(FormFactors kind, int rays) {
        return FormFactorCalculators.make(kind, bounds, rays, Double.POSITIVE_INFINITY);
    }
}
