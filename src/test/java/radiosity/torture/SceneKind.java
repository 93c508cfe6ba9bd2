package radiosity.torture;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;

/** What kinds of scenes a campaign makes. */
enum SceneKind {

    /** Walls, and a lamp in the ceiling. */
    ROOM {
        @Override
        void build(SceneMaker maker) {
            maker.litRoom();
        }
    },
    /** Blocks that stand in the room, hover, or go through its floor. */
    BLOCKS {
        @Override
        void build(SceneMaker maker) {
            maker.litRoom();
            Dice dice = maker.dice;
            for (int n = dice.integer(1, 3); n > 0; n--) {
                double[] at = maker.place();
                double[] low = {at[0] * .7, dice.of(0.0, 0.0, .1, -.05), at[2] * .7};
                double[] high = {at[0], low[1] + maker.high[1] * dice.between(.2, .7), at[2]};
                Material side = Material.wall("block " + n, dice);
                maker.object.box(low, high, false, side, side, side, side, side, side);
            }
        }
    },
    /** A room that light leaves through a wall that is not there. */
    OPEN {
        @Override
        void build(SceneMaker maker) {
            Material[] sides = maker.walls();
            Material ceiling = sides[3];
            sides[3] = null;
            sides[maker.dice.of(0, 1, 4, 5)] = null;
            maker.room(sides);
            maker.ceilingWithLamp(ceiling, Material.lamp("lamp", maker.dice.logarithmic(1, 100), maker.dice));
        }
    },
    /** Triangles at random, through each other. */
    SOUP {
        @Override
        void build(SceneMaker maker) {
            Dice dice = maker.dice;
            for (int n = dice.integer(5, 40); n > 0; n--) {
                Material material = n <= 3 ? Material.lamp("lamp", 10, dice) : Material.wall("side " + n % 4, dice);
                maker.triangle(dice.chance(.4) ? material.onBothSides() : material, maker.place(),
                        dice.between(.3, 2));
            }
        }
    },
    /** Triangles a thousand to a million times as long as wide. */
    SLIVERS {
        @Override
        void build(SceneMaker maker) {
            maker.litRoom();
            Dice dice = maker.dice;
            for (int n = dice.integer(5, 25); n > 0; n--) {
                double[] a = maker.place();
                double[] b = maker.place();
                double[] c = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2 + dice.logarithmic(1e-6, 1e-3), (a[2] + b[2]) / 2};
                maker.object.polygon(Material.wall("sliver", dice), null, a, b, c);
            }
        }
    },
    /** Sheets that lie on the floor and on each other, in the same plane or nearly so. */
    COPLANAR {
        @Override
        void build(SceneMaker maker) {
            maker.litRoom();
            Dice dice = maker.dice;
            for (int n = dice.integer(2, 8); n > 0; n--) {
                double[] at = maker.place();
                double level = dice.of(0.0, 0.0, 1e-7, 1e-5, 1e-3);
                maker.object.rectangle(Material.wall("sheet " + n, dice), maker.middle(), 1, level,
                        new double[] {at[0] * .5, 0, at[2] * .5}, at);
            }
        }
    },
    /** One object many times: turned, mirrored, as another's child. */
    INSTANCES {
        @Override
        void build(SceneMaker maker) throws IOException {
            maker.litRoom();
            ObjectMaker thing = new ObjectMaker();
            Material side = Material.wall("thing", maker.dice);
            thing.box(new double[] {-.5, -.5, -.5}, new double[] {.5, .5, .5}, false, side, side, side, side, side,
                    side);
            maker.instances(thing, maker.dice.integer(2, 10));
        }
    },
    /** Lamps above holes in the ceiling. */
    RECESSED {
        @Override
        void build(SceneMaker maker) {
            Dice dice = maker.dice;
            Material[] sides = maker.walls();
            double[] low = {maker.high[0] * .4, maker.high[1], maker.high[2] * .4};
            double[] high = {maker.high[0] * .5, maker.high[1] + dice.between(.02, .3), maker.high[2] * .5};
            Material ceiling = sides[3];
            sides[3] = null;
            maker.room(sides);
            double[] x = {0, low[0], high[0], maker.high[0]};
            double[] z = {0, low[2], high[2], maker.high[2]};
            for (int i = 0; i < 9; i++) {
                if (i != 4) {
                    maker.object.rectangle(ceiling, maker.middle(), 1, maker.high[1],
                            new double[] {x[i / 3], 0, z[i % 3]}, new double[] {x[i / 3 + 1], 0, z[i % 3 + 1]});
                }
            }
            Material lamp = Material.lamp("lamp", 100, dice);
            maker.object.box(low, high, true, ceiling, ceiling, null, lamp, ceiling, ceiling);
        }
    },
    /** A painted floor. */
    IMAGES {
        @Override
        void build(SceneMaker maker) throws IOException {
            Material[] sides = maker.walls();
            Material ceiling = sides[3];
            sides[3] = null;
            sides[2] = new Material("floor", Material.grey(255), .8, 0, 0, false, maker.image());
            maker.room(sides);
            maker.ceilingWithLamp(ceiling, Material.lamp("lamp", 20, maker.dice));
        }
    },
    /** No surface emits, but distant, point and spot lights do. */
    LIGHTS {
        @Override
        void build(SceneMaker maker) {
            maker.room(maker.walls());
            for (int n = maker.dice.integer(1, 3); n > 0; n--) {
                maker.light();
            }
        }
    },
    /** Walls that reflect .9 to .9999 of the light. */
    WHITE {
        @Override
        void build(SceneMaker maker) {
            withDiffuse(maker, maker.dice.of(.9, .99, .999, .9999));
        }
    },
    /** Walls that reflect nothing. */
    BLACK {
        @Override
        void build(SceneMaker maker) {
            withDiffuse(maker, 0);
        }
    },
    /** Walls that would reflect more than arrives: the program clips their reflectance, and says so. */
    CLIPPED {
        @Override
        void build(SceneMaker maker) {
            Material[] sides = maker.walls();
            Material ceiling = sides[3];
            sides[3] = null;
            sides[0] = new Material("clipped", Material.grey(255), maker.dice.between(1.1, 5), 0, 0, false, null);
            maker.room(sides);
            maker.ceilingWithLamp(ceiling, Material.lamp("lamp", 10, maker.dice));
        }
    },
    /** Lamps that emit a millionth of a millionth, and a million of millions. */
    EMISSION {
        @Override
        void build(SceneMaker maker) {
            Material[] sides = maker.walls();
            Material ceiling = sides[3];
            sides[3] = null;
            sides[0] = Material.lamp("faint", maker.dice.logarithmic(1e-12, 1e-3), maker.dice);
            maker.room(sides);
            maker.ceilingWithLamp(ceiling, Material.lamp("bright", maker.dice.logarithmic(1e-6, 1e12), maker.dice));
        }
    },
    /** Tiny, huge, far from the origin. */
    SCALE {
        @Override
        void build(SceneMaker maker) {
            maker.litRoom();
            double scale = maker.dice.logarithmic(1e-5, 1e5);
            double far = scale * maker.dice.of(0.0, 1.0, 100.0, 1000.0);
            maker.transform(scale, new double[] {far, -far, far});
        }
    },
    /** Nothing emits. */
    DARK {
        @Override
        void build(SceneMaker maker) {
            maker.room(maker.walls());
        }
    },
    /** Polygons with many corners: concave, folded, crossing themselves. */
    POLYGONS {
        @Override
        void build(SceneMaker maker) {
            maker.litRoom();
            Dice dice = maker.dice;
            double[] at = maker.middle();
            int count = dice.integer(5, 60);
            double fold = dice.chance(.5) ? 0 : .1;
            double[][] corners = new double[count][];
            for (int i = 0; i < count; i++) {
                double angle = 2 * StrictMath.PI * i / count * (dice.chance(.1) ? 2 : 1);
                double radius = dice.between(.1, .4);
                corners[i] = new double[] {at[0] + radius * StrictMath.cos(angle), at[1] + fold * dice.between(-1, 1),
                    at[2] + radius * StrictMath.sin(angle)};
            }
            maker.object.polygon(Material.wall("star", dice).onBothSides(), null, corners);
        }
    },
    /** The Cornell box that the project ships. */
    CORNELL {
        @Override
        MadeScene make(Dice dice, Path directory, Path shipped, boolean apart) {
            return new MadeScene(this, shipped.resolve(dice.of("cornell-box.lws", "cornell-box-empty.lws")), null, null,
                    2.2e6, 0, 560);
        }
    },
    /** The study that the project ships: 4,855 triangles, so rounds take a while. */
    STUDY {
        @Override
        MadeScene make(Dice dice, Path directory, Path shipped, boolean apart) {
            return new MadeScene(this, shipped.resolve("study.lws"), null, null, 0, 0, 6);
        }
    };

    private static void withDiffuse(SceneMaker maker, double diffuse) {
        Material[] sides = new Material[6];
        Arrays.fill(sides, new Material("wall", Material.grey(255), diffuse, 0, 0, false, null));
        Material ceiling = sides[3];
        sides[3] = null;
        maker.room(sides);
        maker.ceilingWithLamp(ceiling, Material.lamp("lamp", 10, maker.dice).with(diffuse));
    }

    /** Adds what makes the kind. */
    void build(SceneMaker maker) throws IOException {
        throw new IllegalStateException(name());
    }

    /**
     * Makes a scene.
     *
     * @param directory for its files
     * @param shipped   directory with the project's scenes
     * @param apart     whether objects lie in a directory of their own
     */
    MadeScene make(Dice dice, Path directory, Path shipped, boolean apart) throws IOException {
        Files.createDirectories(directory);
        SceneMaker maker = new SceneMaker(dice, directory, apart);
        build(maker);
        return maker.made(this);
    }

    /** Whether surfaces pass through each other at any angle, so that some elements are partly covered. */
    boolean overlaps() {
        return this == SOUP;
    }

    boolean isShipped() {
        return this == CORNELL || this == STUDY;
    }
}
