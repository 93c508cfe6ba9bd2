package radiosity.viewer;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.jogamp.java3d.Appearance;
import org.jogamp.java3d.BoundingSphere;
import org.jogamp.java3d.BranchGroup;
import org.jogamp.java3d.ColoringAttributes;
import org.jogamp.java3d.GeometryArray;
import org.jogamp.java3d.IndexedTriangleArray;
import org.jogamp.java3d.J3DBuffer;
import org.jogamp.java3d.LineArray;
import org.jogamp.java3d.Shape3D;
import org.jogamp.java3d.Transform3D;
import org.jogamp.java3d.TransformGroup;
import org.jogamp.vecmath.Color3f;
import org.jogamp.vecmath.Point3d;
import radiosity.output.gltf.LitScene;
import radiosity.output.mesh.Mesh;
import radiosity.scene.Affine;
import radiosity.scene.Vec3;
import radiosity.util.Aabb;

/** A scene as Java 3D shapes, one per side of a surface, which refer to buffers outside the Java heap. */
final class SceneShapes {

    private static final int FORMAT = GeometryArray.COORDINATES | GeometryArray.COLOR_3 | GeometryArray.BY_REFERENCE
            | GeometryArray.BY_REFERENCE_INDICES | GeometryArray.USE_COORD_INDEX_ONLY
            | GeometryArray.USE_NIO_BUFFER;

    private static final Color3f OUTLINE = new Color3f(1, .75f, .1f);

    private final BranchGroup group = new BranchGroup();
    /** 1 per mesh. */
    private final List<IndexedTriangleArray> triangles = new ArrayList<>();
    /** 1 per mesh: radiosity as it is shown, 3 per vertex, W/m². */
    private final List<FloatBuffer> radiosity = new ArrayList<>();

    /**
     * @param nodes 1 per node of the hierarchy: whether the node is selected
     * @param box   box around the selected nodes, scene units
     */
    record Selection(boolean[] nodes, Aabb box) { }

    /** Group of the selected object's shapes. */
    private final TransformGroup moved = new TransformGroup();
    private final Vec3 origin;

    /**
     * Makes the shapes; their coordinates are relative to the scene's origin.
     *
     * @param selection the object that {@link #place} can move; null for none
     */
    SceneShapes(LitScene scene, Appearance appearance, Selection selection) {
        origin = scene.origin();
        moved.setCapability(TransformGroup.ALLOW_TRANSFORM_WRITE);
        group.addChild(moved);
        group.setCapability(BranchGroup.ALLOW_DETACH);
        BoundingSphere bounds = bounds(scene);
        for (Mesh mesh : scene.meshes()) {
            radiosity.add(buffer(mesh.shown()));
            triangles.add(triangles(mesh, radiosity.get(radiosity.size() - 1)));
            boolean isSelected = selection != null && mesh.node() >= 0 && selection.nodes()[mesh.node()];
            (isSelected ? moved : group).addChild(shape(triangles.get(triangles.size() - 1), appearance, bounds));
        }
        if (selection != null) {
            moved.addChild(shape(edges(selection.box()), outline(), bounds));
        }
    }

    BranchGroup group() {
        return group;
    }

    /** @param map from the selected object's position in the scene to the position to draw it at, scene units */
    void place(Affine map) {
        Affine shifted = Affine.move(-origin.x(), -origin.y(), -origin.z()).times(map)
                .times(Affine.move(origin.x(), origin.y(), origin.z()));
        double[] matrix = Arrays.copyOf(shifted.m(), 16);
        matrix[15] = 1;
        moved.setTransform(new Transform3D(matrix));
    }

    private LineArray edges(Aabb box) {
        LineArray lines = new LineArray(24, GeometryArray.COORDINATES);
        int vertex = 0;
        for (int corner = 0; corner < 8; corner++) {
            for (int axis = 1; axis < 8; axis *= 2) {
                if ((corner & axis) == 0) {
                    for (int end : new int[] {corner, corner | axis}) {
                        Vec3 p = box.corner(end).minus(origin);
                        lines.setCoordinate(vertex++, new Point3d(p.x(), p.y(), p.z()));
                    }
                }
            }
        }
        return lines;
    }

    private static Appearance outline() {
        Appearance appearance = new Appearance();
        appearance.setColoringAttributes(new ColoringAttributes(OUTLINE, ColoringAttributes.SHADE_FLAT));
        return appearance;
    }

    /** Replaces the radiosity of all vertices by that of a scene with the same meshes. */
    void light(LitScene scene) {
        for (int m = 0; m < triangles.size(); m++) {
            FloatBuffer to = radiosity.get(m);
            float[] from = scene.meshes().get(m).shown();
            triangles.get(m).updateData(geometry -> to.rewind().put(from).rewind());
        }
    }

    static BoundingSphere bounds(LitScene scene) {
        Extent extent = Extent.of(scene);
        Vec3 c = extent.centre().minus(scene.origin());
        return new BoundingSphere(new Point3d(c.x(), c.y(), c.z()), extent.size());
    }

    private static IndexedTriangleArray triangles(Mesh mesh, FloatBuffer radiosity) {
        IndexedTriangleArray triangles = new IndexedTriangleArray(mesh.vertices(), FORMAT, mesh.corners().length);
        triangles.setCapability(GeometryArray.ALLOW_REF_DATA_WRITE);
        triangles.setCoordRefBuffer(new J3DBuffer(buffer(mesh.positions())));
        triangles.setColorRefBuffer(new J3DBuffer(radiosity));
        triangles.setCoordIndicesRef(mesh.corners());
        return triangles;
    }

    /** Makes a shape with given bounds, which Java 3D would otherwise search for. */
    static Shape3D shape(GeometryArray triangles, Appearance appearance, BoundingSphere bounds) {
        Shape3D shape = new Shape3D(triangles, appearance);
        shape.setPickable(false);
        shape.setCollidable(false);
        shape.setBoundsAutoCompute(false);
        shape.setBounds(bounds);
        return shape;
    }

    private static FloatBuffer buffer(float[] values) {
        return ByteBuffer.allocateDirect(4 * values.length).order(ByteOrder.nativeOrder())
                .asFloatBuffer().put(values).rewind();
    }
}
