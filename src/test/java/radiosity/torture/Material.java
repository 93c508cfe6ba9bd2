package radiosity.torture;

/**
 * A surface of a made scene.
 *
 * @param colour     red, green, blue, each from 0 to 255
 * @param diffuse    times the colour is reflectance; above 1 the program clips it
 * @param luminosity times the colour is exitance, W/m2
 * @param specular   times the colour is exitance where {@code --emission specular} asks for it, W/m2
 * @param image      a file that varies the colour, or null
 */
record Material(String name, int[] colour, double diffuse, double luminosity, double specular, boolean twoSided,
                String image) {

    static Material wall(String name, Dice dice) {
        int[] colour = {dice.integer(60, 255), dice.integer(60, 255), dice.integer(60, 255)};
        return new Material(name, dice.chance(.3) ? grey(dice.integer(60, 255)) : colour, dice.between(.2, .9), 0, 0,
                false, null);
    }

    static Material lamp(String name, double luminosity, Dice dice) {
        return new Material(name, dice.of(grey(255), new int[] {255, 220, 160}), dice.chance(.5) ? 0 : .3, luminosity,
                luminosity / 2, false, null);
    }

    static int[] grey(int value) {
        return new int[] {value, value, value};
    }

    Material with(double newDiffuse) {
        return new Material(name, colour, newDiffuse, luminosity, specular, twoSided, image);
    }

    Material onBothSides() {
        return new Material(name, colour, diffuse, luminosity, specular, true, image);
    }

    Material painted(String file) {
        return new Material(name, colour, diffuse, luminosity, specular, twoSided, file);
    }
}
