package radiosity.patch;

/**
 * The elements below a node, by value, and a radiosity at the corners of each.
 *
 * @param face      face on which it lies
 * @param path      its top node below the face, see {@link Path}
 * @param child     1 per node, breadth first: first of four consecutive children, or -1
 * @param radiosity 3 x channels per node, corner by corner; 0 for inner nodes. W/m²
 */
public record PatchTree(int face, long path, int[] child, double[] radiosity) {

    /** Radiosity times area summed over the elements, per channel, of the scene's squared size; added to {@code sum}. */
    public void addFlux(Faces faces, double[] sum) {
        add(0, faces.area(face) / (1L << 2 * Path.level(path)), sum);
    }

    private void add(int node, double area, double[] sum) {
        for (int k = 0; k < 4 && child[node] >= 0; k++) {
            add(child[node] + k, area / 4, sum);
        }
        for (int i = 0; i < 3 * sum.length && child[node] < 0; i++) {
            sum[i % sum.length] += radiosity[3 * sum.length * node + i] * area / 3;
        }
    }

    /** Mean radiosity below a node, per channel; added to {@code mean}. */
    public void addMean(int node, double share, double[] mean) {
        for (int k = 0; k < 4 && child[node] >= 0; k++) {
            addMean(child[node] + k, share / 4, mean);
        }
        for (int i = 0; i < 3 * mean.length && child[node] < 0; i++) {
            mean[i % mean.length] += share / 3 * radiosity[3 * mean.length * node + i];
        }
    }
}
