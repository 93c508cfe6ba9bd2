package radiosity.viewer;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.jogamp.java3d.Appearance;
import org.jogamp.java3d.BoundingSphere;
import org.jogamp.java3d.BranchGroup;
import org.jogamp.java3d.GeometryArray;
import org.jogamp.java3d.IndexedTriangleArray;
import org.jogamp.java3d.J3DBuffer;
import org.jogamp.java3d.Shape3D;
import org.jogamp.vecmath.Point3d;
import radiosity.output.LitScene;
import radiosity.output.Mesh;
import radiosity.scene.Vec3;

/** A scene as Java 3D has it: one shape per side of a surface, by reference to buffers outside the heap. */
final class SceneShapes {

    private static final int FORMAT = GeometryArray.COORDINATES | GeometryArray.COLOR_3 | GeometryArray.BY_REFERENCE
            | GeometryArray.BY_REFERENCE_INDICES | GeometryArray.USE_COORD_INDEX_ONLY
            | GeometryArray.USE_NIO_BUFFER;

    private SceneShapes() { }

    /** Positions count from the scene's origin. */
    static BranchGroup of(LitScene scene, Appearance appearance) {
        BranchGroup group = new BranchGroup();
        group.setCapability(BranchGroup.ALLOW_DETACH);
        BoundingSphere bounds = bounds(scene);
        for (Mesh mesh : scene.meshes()) {
            group.addChild(shape(triangles(mesh), appearance, bounds));
        }
        return group;
    }

    static BoundingSphere bounds(LitScene scene) {
        Extent extent = Extent.of(scene);
        Vec3 c = extent.centre().minus(scene.origin());
        return new BoundingSphere(new Point3d(c.x(), c.y(), c.z()), extent.size());
    }

    private static IndexedTriangleArray triangles(Mesh mesh) {
        IndexedTriangleArray triangles = new IndexedTriangleArray(mesh.vertices(), FORMAT, mesh.corners().length);
        triangles.setCoordRefBuffer(buffer(mesh.positions()));
        triangles.setColorRefBuffer(buffer(mesh.radiosity()));
        triangles.setCoordIndicesRef(mesh.corners());
        return triangles;
    }

    /** A shape whose bounds Java 3D need not search. */
    static Shape3D shape(GeometryArray triangles, Appearance appearance, BoundingSphere bounds) {
        Shape3D shape = new Shape3D(triangles, appearance);
        shape.setPickable(false);
        shape.setCollidable(false);
        shape.setBoundsAutoCompute(false);
        shape.setBounds(bounds);
        return shape;
    }

    private static J3DBuffer buffer(float[] values) {
        return new J3DBuffer(ByteBuffer.allocateDirect(4 * values.length).order(ByteOrder.nativeOrder())
                .asFloatBuffer().put(values).rewind());
    }
}
