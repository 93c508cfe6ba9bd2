package radiosity.testkit;

import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/**
 * Rooms dug out of a block of cells: every square between an air cell and a solid one becomes a polygon that faces the
 * air. Polygons meet edge to edge, so the room is watertight, and no part of a surface is hidden behind another.
 *
 * @param x planes between cells along x, ascending; one more than there are cells; and so on
 */
public record Cells(double[] x, double[] y, double[] z) {

    /** Which cells are air. */
    @FunctionalInterface
    public interface Air {

        /** @param i number of the cell along x, from 0; and so on */
        boolean at(int i, int j, int k);
    }

    /** The surface of a square. */
    @FunctionalInterface
    public interface Paint {

        /** @param side which side of the air: 0 low x, 1 high x, 2 low y, 3 high y, 4 low z, 5 high z */
        Surface at(int i, int j, int k, int side);
    }

    /** A room of one surface. */
    public Scene room(String name, Air air, Surface surface) {
        return room(name, air, (i, j, k, side) -> surface);
    }

    /** @param paint the surface of each square, by the air cell before it */
    public Scene room(String name, Air air, Paint paint) {
        SceneBuilder builder = new SceneBuilder();
        for (int i = 0; i < x.length - 1; i++) {
            for (int j = 0; j < y.length - 1; j++) {
                for (int k = 0; k < z.length - 1; k++) {
                    if (air.at(i, j, k)) {
                        walls(builder, air, paint, i, j, k);
                    }
                }
            }
        }
        return builder.scene(name);
    }

    private void walls(SceneBuilder builder, Air air, Paint paint, int i, int j, int k) {
        Box cell = new Box(new Vec3(x[i], y[j], z[k]), new Vec3(x[i + 1], y[j + 1], z[k + 1]));
        for (int side = 0; side < 6; side++) {
            int step = side % 2 == 0 ? -1 : 1;
            int u = i + (side / 2 == 0 ? step : 0);
            int v = j + (side / 2 == 1 ? step : 0);
            int w = k + (side / 2 == 2 ? step : 0);
            boolean outside = u < 0 || v < 0 || w < 0 || u > x.length - 2 || v > y.length - 2 || w > z.length - 2;
            if (outside || !air.at(u, v, w)) {
                builder.polygon(paint.at(i, j, k, side), cell.inside(side));
            }
        }
    }
}
