package radiosity.partition;

import java.io.DataInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import radiosity.mesh.RadiosityNodes;
import radiosity.protocol.Wire;
import radiosity.util.ArraySize;

/** What has arrived at some receiving points, as hosts tell each other: channels per point. */
public final class PointIrradiance {

    private final RadiosityNodes nodes;

    PointIrradiance(RadiosityNodes nodes) {
        this.nodes = nodes;
    }

    /** @return a number, then what has arrived at these points */
    byte[] told(int number, int[] points) {
        double[] irradiance = nodes.light().irradiance();
        int channels = nodes.channels();
        ByteBuffer bytes = ByteBuffer.allocate(ArraySize.of("bytes of the light at points of a border",
                Integer.BYTES + size() * points.length)).putInt(number);
        for (int v : points) {
            for (int c = 0; c < channels; c++) {
                bytes.putDouble(irradiance[channels * v + c]);
            }
        }
        return bytes.array();
    }

    /** Bytes per point. */
    private long size() {
        return (long) Double.BYTES * nodes.channels();
    }

    void put(int[] points, DataInputStream irradiance) throws IOException {
        ByteBuffer bytes = ByteBuffer.wrap(Wire.exactly(irradiance, size() * points.length));
        for (int i = 0; i < points.length; i++) {
            put(points[i], bytes, (int) size() * i);
        }
    }

    /** At one point: from a place on. */
    public void put(int point, ByteBuffer irradiance, int at) {
        for (int c = 0; c < nodes.channels(); c++) {
            nodes.light().irradiance()[nodes.channels() * point + c] = irradiance.getDouble(at + Double.BYTES * c);
        }
    }
}
