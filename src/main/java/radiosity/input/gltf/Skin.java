package radiosity.input.gltf;

import java.util.List;
import radiosity.scene.Affine;

/**
 * The joints of a skin, at rest.
 *
 * @param joints per joint the map from the mesh's space to the scene's: joint's world after its inverse bind matrix
 */
record Skin(List<Affine> joints) {

    /**
     * Moves each point to the weighted mean of its images by its joints; a point without weights stays where it is.
     *
     * @param points  x, y, z of each point; modified
     * @param numbers indices of joints, 4 per point in each array of the list
     * @param weights weights of these joints, in the same order
     */
    void move(float[] points, List<float[]> numbers, List<float[]> weights) {
        for (int p = 0; p < points.length / 3; p++) {
            double[] moved = new double[3];
            double sum = 0;
            for (int i = 0; i < 4 * numbers.size(); i++) {
                double weight = weights.get(i / 4)[4 * p + i % 4];
                int joint = (int) numbers.get(i / 4)[4 * p + i % 4];
                if (weight != 0 && joint >= 0 && joint < joints.size()) {
                    sum += weight;
                    for (int k = 0; k < 3; k++) {
                        moved[k] += weight * joints.get(joint).point(k, points[3 * p], points[3 * p + 1],
                                points[3 * p + 2]);
                    }
                }
            }
            for (int k = 0; k < 3 && sum != 0; k++) {
                points[3 * p + k] = (float) (moved[k] / sum);
            }
        }
    }
}
