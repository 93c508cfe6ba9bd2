package radiosity.input.gltf;

import java.util.List;
import radiosity.scene.Affine;

/**
 * Joints as they stand at rest.
 *
 * @param joints from the mesh's space, as it was bound to a joint, to the scene
 */
record Skin(List<Affine> joints) {

    /**
     * Moves points by the weighted mean of their joints.
     *
     * @param points  x, y, z of each; are changed
     * @param numbers of joints, 4 per point and list
     * @param weights as many
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
            for (int k = 0; k < 3; k++) {
                points[3 * p + k] = (float) (moved[k] / sum);
            }
        }
    }
}
