package radiosity.partition;

import java.io.DataInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import radiosity.mesh.Block;
import radiosity.mesh.face.NodePath;
import radiosity.protocol.BlockState;
import radiosity.protocol.Wire;
import radiosity.setup.InitialMesh;

/**
 * What a host says of its {@link Seam}.
 *
 * @param patches by their tops
 * @param state   of them, see {@link BlockState}
 * @param given   keys of the points of which it says with every answer what has arrived there, in this order
 */
public record GhostReport(Block patches, byte[] state, long[] given) {

    public static GhostReport decode(byte[] bytes, InitialMesh mesh) throws IOException {
        DataInputStream in = Wire.input(bytes);
        int[] face = new int[Wire.count(in, Integer.BYTES + Long.BYTES)];
        long[] path = new long[face.length];
        for (int i = 0; i < face.length; i++) {
            face[i] = in.readInt();
            path[i] = in.readLong();
            if (face[i] < 0 || face[i] >= mesh.faces.count() || path[i] < NodePath.FACE
                    || NodePath.level(path[i]) > mesh.patcher.level(face[i])) {
                throw new IOException("seam: expected patches of the mesh, got " + face[i] + ", " + path[i]);
            }
        }
        byte[] state = Wire.bytes(in);
        long[] given = new long[Wire.count(in, 1) / Long.BYTES];
        ByteBuffer.wrap(Wire.exactly(in, Long.BYTES * given.length)).asLongBuffer().get(given);
        return new GhostReport(new Block(0, face, path), state, given);
    }
}
