package radiosity.world;

import java.io.IOException;
import java.rmi.RemoteException;
import radiosity.scene.Scene;

/**
 * Everything in a scene, wherever its elements are (section 4.5.1 of the paper).
 *
 * <p>A world updates its elements for the shots it is given; which shots, and until when, is decided by
 * {@link ProgressiveRadiosity}.
 */
public abstract sealed class World implements AutoCloseable permits LocalWorld {

    final InitialMesh mesh;

    World(InitialMesh mesh) {
        this.mesh = mesh;
    }

    public Scene scene() {
        return mesh.scene;
    }

    public RadiositySettings settings() {
        return mesh.settings;
    }

    /** Largest area of a patch of the initial mesh, square scene units: as asked, or as chosen from the scene. */
    public double patchArea() {
        return mesh.patchArea();
    }

    /** Number of patches of the initial mesh. */
    public long patches() {
        return mesh.patcher.patches();
    }

    /** Triangles of the scene that are too small to radiate; they still occlude. */
    public int droppedTriangles() {
        return mesh.faces.dropped();
    }

    /** 1 where everything in the scene is grey, else 3. */
    public int channels() {
        return mesh.faces.channels();
    }

    /**
     * One round on all partitions.
     *
     * @param shots as written by {@link Wire}
     */
    abstract Answer shoot(byte[] shots, int most) throws IOException;

    /** The state of a block, from whoever owns it. */
    abstract byte[] block(int id) throws RemoteException;

    abstract void restore(int id, byte[] state) throws RemoteException;

    @Override
    public void close() { }
}
