package radiosity.certificate;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import radiosity.protocol.GatherPoints;

/** The places at which an audit has the partitions gather light, and the sums to which that light is added. */
final class AuditGather {

    /**
     * @param x     x, y, z of the place from index {@code at} on, in the scene brought to size 1
     * @param key   the number from which the rays follow
     * @param slack powers of two by which the light that a ray may carry is raised
     * @param sum   1 per channel: to which the irradiance is added, W/m²
     */
    private record Place(float[] x, int at, int face, long key, GatherPoints.Rays rays, int slack, double[] sum) { }

    private final List<Place> places = new ArrayList<>();

    void add(float[] x, int at, int face, long key, GatherPoints.Rays rays, int slack, double[] sum) {
        places.add(new Place(x, at, face, key, rays, slack, sum));
    }

    boolean isEmpty() {
        return places.isEmpty();
    }

    /**
     * Deals the places to blocks, in proportion to the blocks' elements, as the owners of blocks have work of that
     * proportion.
     *
     * @param elements 1 per block: number of its elements
     */
    GatherPoints points(int[] elements) {
        int count = places.size();
        GatherPoints points = new GatherPoints(new float[3 * count], new int[count], new long[count], new byte[count],
                new byte[count], first(elements, count));
        for (int i = 0; i < count; i++) {
            Place at = places.get(i);
            System.arraycopy(at.x, at.at, points.place(), 3 * i, 3);
            points.face()[i] = at.face;
            points.key()[i] = at.key;
            points.rays()[i] = (byte) at.rays.ordinal();
            points.slack()[i] = (byte) at.slack;
        }
        return points;
    }

    private static int[] first(int[] elements, int count) {
        int[] first = new int[elements.length + 1];
        long all = 0;
        for (int its : elements) {
            all += its;
        }
        long before = 0;
        for (int b = 0; b < elements.length; b++) {
            before += elements[b];
            first[b + 1] = (int) (count * before / Math.max(1, all));
        }
        return first;
    }

    /** Adds the irradiance that partitions have answered, as {@code PointGatherer} writes it. */
    void take(List<byte[]> answers) {
        for (byte[] answer : answers) {
            for (ByteBuffer in = ByteBuffer.wrap(answer); in.hasRemaining();) {
                double[] sum = places.get(in.getInt()).sum;
                for (int c = 0; c < sum.length; c++) {
                    sum[c] += in.getDouble();
                }
            }
        }
    }
}
