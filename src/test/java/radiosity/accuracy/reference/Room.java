package radiosity.accuracy.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneBuilder;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/**
 * A closed room of rectangles with y up and one lamp, for the path tracer and, as a scene, for the program.
 *
 * @param name       its name in the file of references
 * @param size       longest edge of the room, m
 * @param rectangles all rectangles; a floor may run under a block
 */
record Room(String name, double size, List<Rectangle> rectangles) {

    /** Points keep this part of the room's size away from every other rectangle. */
    static final double MARGIN = 0.02;

    /**
     * A point on a rectangle.
     *
     * @param on       index of the rectangle in the room
     * @param position x, y, z, m
     */
    record Place(int on, double[] position) { }

    /** 4 m x 3 m x 4 m with walls of three colours, two turned blocks, and a lamp of 1.6 m x 1.2 m in the ceiling. */
    static Room withBlocks() {
        Material white = Material.wall("white", 0.55, 0.52, 0.48);
        Shell shell = new Shell(3);
        shell.floor(white, 0, 4, 0, 4);
        shell.ceilingWithLamp(white, new double[] {0, 4, 0, 4}, new double[] {1.2, 2.8, 1.4, 2.6});
        shell.sides(Material.wall("red", 0.5, 0.1, 0.08), Material.wall("green", 0.12, 0.45, 0.15),
                new double[] {0, 4, 0, 4}, white);
        shell.block(Material.wall("yellow", 0.5, 0.4, 0.1),
                new double[] {0.6, 0, 0.9}, new double[] {1, 1.7, 0.9}, 0.3);
        shell.block(Material.wall("blue", 0.15, 0.25, 0.5),
                new double[] {2.1, 0, 2.5}, new double[] {1.1, 0.8, 1}, -0.4);
        return new Room("blocks", 4, shell.rectangles);
    }

    /**
     * Two rooms of 2.6 m height behind each other, a wall of 0.2 m with a doorway of 2 m x 2.2 m between them,
     * and a lamp in the first.
     */
    static Room twoRooms() {
        Material white = Material.wall("white", 0.55, 0.53, 0.5);
        Material blue = Material.wall("blue", 0.25, 0.35, 0.5);
        Material wood = Material.wall("wood", 0.45, 0.3, 0.2);
        Shell shell = new Shell(2.6);
        shell.floor(wood, 0, 3, 0, 4);
        shell.floor(wood, 3, 3.2, 0.8, 2.8);
        shell.floor(wood, 3.2, 6, 0, 4);
        shell.ceilingWithLamp(white, new double[] {0, 3, 0, 4}, new double[] {0.8, 1.8, 1.2, 2.8});
        shell.ceiling(white, 3.2, 6, 0, 4);
        shell.add(white, new double[] {0, 0, 0}, new double[] {0, 2.6, 0}, new double[] {0, 0, 4});
        shell.add(blue, new double[] {6, 0, 0}, new double[] {0, 0, 4}, new double[] {0, 2.6, 0});
        shell.ends(white, new double[] {0, 3, 0, 4});
        shell.ends(blue, new double[] {3.2, 6, 0, 4});
        for (double[] part : new double[][] {{0, 2.6, 0, 0.8}, {0, 2.6, 2.8, 4}, {2.2, 2.6, 0.8, 2.8}}) {
            double[] up = {0, part[1] - part[0], 0};
            double[] along = {0, 0, part[3] - part[2]};
            shell.add(white, new double[] {3, part[0], part[2]}, along, up);
            shell.add(blue, new double[] {3.2, part[0], part[2]}, up, along);
        }
        shell.add(white, new double[] {3, 0, 0.8}, new double[] {0.2, 0, 0}, new double[] {0, 2.2, 0});
        shell.add(white, new double[] {3, 0, 2.8}, new double[] {0, 2.2, 0}, new double[] {0.2, 0, 0});
        shell.add(white, new double[] {3, 2.2, 0.8}, new double[] {0.2, 0, 0}, new double[] {0, 0, 2});
        return new Room("doorway", 6, shell.rectangles);
    }

    /** The room of that name. */
    static Room named(String name) {
        return List.of(withBlocks(), twoRooms()).stream().filter(room -> room.name.equals(name)).findFirst()
                .orElseThrow();
    }

    /** The same room with other materials. */
    Room with(UnaryOperator<Material> other) {
        return new Room(name, size, rectangles.stream()
                .map(r -> new Rectangle(other.apply(r.material()), r.origin(), r.u(), r.v())).toList());
    }

    /** What the program renders. */
    Scene scene() {
        SceneBuilder builder = new SceneBuilder();
        for (Rectangle r : rectangles) {
            Material m = r.material();
            builder.polygon(new Surface(m.name(), rgb(m.exitance()), rgb(m.reflectance()), false),
                    vector(r.at(0, 0)), vector(r.at(1, 0)), vector(r.at(1, 1)), vector(r.at(0, 1)));
        }
        return builder.scene(name);
    }

    private static Rgb rgb(double[] v) {
        return new Rgb(v[0], v[1], v[2]);
    }

    private static Vec3 vector(double[] v) {
        return new Vec3(v[0], v[1], v[2]);
    }

    /**
     * Points on what does not emit, one at random in each of as many equal parts of its area; none nearer than the
     * {@link #MARGIN} to another rectangle, and none under a block.
     */
    List<Place> places(int count, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        PathTracer tracer = new PathTracer(this);
        List<Place> places = new ArrayList<>();
        double area = rectangles.stream().filter(r -> !r.material().emits()).mapToDouble(Rectangle::area).sum();
        while (places.size() < count) {
            int on = rectangleAt(area * (places.size() + random.nextDouble()) / count);
            double[] position = rectangles.get(on).at(random.nextDouble(), random.nextDouble());
            if (isClear(on, position) && !tracer.isBuried(on, position)) {
                places.add(new Place(on, position));
            }
        }
        return places;
    }

    /** Index of what does not emit where the running sum of areas reaches a value, m². */
    private int rectangleAt(double area) {
        double rest = area;
        int last = 0;
        for (int i = 0; i < rectangles.size() && rest >= 0; i++) {
            if (!rectangles.get(i).material().emits()) {
                rest -= rectangles.get(i).area();
                last = i;
            }
        }
        return last;
    }

    private boolean isClear(int on, double[] position) {
        for (int i = 0; i < rectangles.size(); i++) {
            if (i != on && rectangles.get(i).distance(position) < MARGIN * size) {
                return false;
            }
        }
        return true;
    }

    /** Collects the rectangles of a room of one height; an area is low x, high x, low z, high z, in m. */
    private static final class Shell {

        private final List<Rectangle> rectangles = new ArrayList<>();
        private final double height;

        Shell(double height) {
            this.height = height;
        }

        void add(Material material, double[] origin, double[] u, double[] v) {
            rectangles.add(new Rectangle(material, origin, u, v));
        }

        void floor(Material material, double x0, double x1, double z0, double z1) {
            add(material, new double[] {x0, 0, z0}, new double[] {0, 0, z1 - z0}, new double[] {x1 - x0, 0, 0});
        }

        void ceiling(Material material, double x0, double x1, double z0, double z1) {
            add(material, new double[] {x0, height, z0}, new double[] {x1 - x0, 0, 0}, new double[] {0, 0, z1 - z0});
        }

        /** Four parts of a ceiling around a lamp that lies in it. */
        void ceilingWithLamp(Material material, double[] all, double[] lamp) {
            ceiling(material, all[0], lamp[0], all[2], all[3]);
            ceiling(material, lamp[1], all[1], all[2], all[3]);
            ceiling(material, lamp[0], lamp[1], all[2], lamp[2]);
            ceiling(material, lamp[0], lamp[1], lamp[3], all[3]);
            ceiling(new Material("lamp", new double[] {12, 10, 8}, new double[] {0.2, 0.2, 0.2}), lamp[0], lamp[1],
                    lamp[2], lamp[3]);
        }

        /** The four walls around an area. */
        void sides(Material low, Material high, double[] area, Material ends) {
            double[] up = {0, height, 0};
            double[] along = {0, 0, area[3] - area[2]};
            add(low, new double[] {area[0], 0, area[2]}, up, along);
            add(high, new double[] {area[1], 0, area[2]}, along, up);
            ends(ends, area);
        }

        /** The two walls at low and high z. */
        void ends(Material material, double[] area) {
            double[] up = {0, height, 0};
            double[] across = {area[1] - area[0], 0, 0};
            add(material, new double[] {area[0], 0, area[2]}, across, up);
            add(material, new double[] {area[0], 0, area[3]}, up, across);
        }

        /**
         * Sides and top of a block that stands on the floor.
         *
         * @param corner about which it is turned
         * @param size   width, height and depth, m
         * @param angle  radians about y
         */
        void block(Material material, double[] corner, double[] size, double angle) {
            double[] a = {size[0] * Math.cos(angle), 0, -size[0] * Math.sin(angle)};
            double[] b = {size[2] * Math.sin(angle), 0, size[2] * Math.cos(angle)};
            double[] up = {0, size[1], 0};
            Rectangle base = new Rectangle(material, corner, a, b);
            add(material, corner, up, a);
            add(material, base.at(0, 1), a, up);
            add(material, corner, b, up);
            add(material, base.at(1, 0), up, b);
            double[] top = {corner[0], corner[1] + size[1], corner[2]};
            add(material, top, b, a);
        }
    }
}
