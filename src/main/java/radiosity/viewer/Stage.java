package radiosity.viewer;

import java.awt.GraphicsConfiguration;
import java.awt.GraphicsEnvironment;
import org.jogamp.java3d.BranchGroup;
import org.jogamp.java3d.GraphicsConfigTemplate3D;
import org.jogamp.java3d.Locale;
import org.jogamp.java3d.PhysicalBody;
import org.jogamp.java3d.PhysicalEnvironment;
import org.jogamp.java3d.Transform3D;
import org.jogamp.java3d.View;
import org.jogamp.java3d.ViewPlatform;
import org.jogamp.java3d.VirtualUniverse;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;
import radiosity.scene.Camera;
import radiosity.scene.Vec3;

/** The Java 3D part of a window: a universe with one scene and one eye (figure 14 of the paper). */
final class Stage {

    /**
     * Distance of the near plane from the eye, and of the far plane from the scene's centre, relative to the scene's
     * size.
     */
    private static final double NEAR = 1e-3;
    private static final double BEHIND = 1;

    private final Locale locale = new Locale(new VirtualUniverse());
    private final View view = new View();
    private final SceneCanvas canvas;
    private BranchGroup scene;

    Stage() {
        canvas = new SceneCanvas(configuration());
        view.setPhysicalBody(new PhysicalBody());
        view.setPhysicalEnvironment(new PhysicalEnvironment());
        view.setCompatibilityModeEnable(true);
        view.setSceneAntialiasingEnable(true);
        view.addCanvas3D(canvas);
        ViewPlatform platform = new ViewPlatform();
        BranchGroup group = new BranchGroup();
        group.addChild(platform);
        view.attachViewPlatform(platform);
        locale.addBranchGraph(group);
    }

    private static GraphicsConfiguration configuration() {
        GraphicsConfigTemplate3D template = new GraphicsConfigTemplate3D();
        template.setSceneAntialiasing(GraphicsConfigTemplate3D.PREFERRED);
        template.setDepthSize(24);
        return GraphicsEnvironment.getLocalGraphicsEnvironment().getDefaultScreenDevice()
                .getBestConfiguration(template);
    }

    SceneCanvas canvas() {
        return canvas;
    }

    /** Replaces the scene shown. */
    void scene(BranchGroup other) {
        locale.addBranchGraph(other);
        if (scene != null) {
            scene.detach();
        }
        scene = other;
    }

    /**
     * Sets the camera.
     *
     * @param origin origin of the scene's coordinates, scene units
     * @param extent size and position of the scene
     */
    void look(Camera camera, Vec3 origin, Extent extent) {
        Vec3 eye = camera.position().minus(origin);
        Vec3 at = eye.plus(camera.forward().times(extent.size()));
        Transform3D toEye = new Transform3D();
        toEye.lookAt(new Point3d(eye.x(), eye.y(), eye.z()), new Point3d(at.x(), at.y(), at.z()),
                new Vector3d(camera.up().x(), camera.up().y(), camera.up().z()));
        double width = 2 * Math.atan(Math.tan(camera.verticalHalfAngle()) * camera.aspect());
        double far = camera.position().minus(extent.centre()).length() + BEHIND * extent.size();
        Transform3D projection = new Transform3D();
        projection.perspective(width, camera.aspect(), NEAR * extent.size(), far);
        view.setVpcToEc(toEye);
        view.setLeftProjection(projection);
        view.setRightProjection(projection);
    }

    /** Draws the picture again, even where nothing in the scene has changed. */
    void redraw() {
        view.repaint();
    }

    void close() {
        view.removeAllCanvas3Ds();
        locale.getVirtualUniverse().removeAllLocales();
    }
}
