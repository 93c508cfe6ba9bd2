package radiosity.scenes;

/** What the study is made of. Reflectances are those of matt paints, woods and cloths; exitances in W/m². */
final class Palette {

    static final Material PLASTER = Material.paint("plaster", .76, .72, .64);
    static final Material CEILING = Material.paint("ceiling", .85, .84, .81);
    static final Material ACCENT = Material.paint("accent wall", .17, .30, .31);
    static final Material WOODWORK = Material.paint("white woodwork", .80, .79, .75);
    static final Material[] OAK = {
        Material.paint("oak 1", .43, .31, .20), Material.paint("oak 2", .38, .27, .17),
        Material.paint("oak 3", .47, .35, .23), Material.paint("oak 4", .35, .24, .15)};
    static final Material WALNUT = Material.paint("walnut", .24, .13, .07);
    static final Material BEECH = Material.paint("beech", .58, .42, .26);
    static final Material LINEN = Material.paint("linen", .74, .68, .57);
    static final Material RUST = Material.paint("rust cloth", .56, .20, .10);
    static final Material MUSTARD = Material.paint("mustard cloth", .66, .44, .10);
    static final Material TEAL = Material.paint("teal cloth", .10, .34, .35);
    static final Material CREAM = Material.paint("cream wool", .78, .72, .60);
    static final Material BRICK = Material.paint("brick wool", .45, .14, .10);
    static final Material BLACK = Material.paint("black metal", .05, .05, .05);
    static final Material BRASS = Material.paint("brass", .60, .44, .18);
    static final Material CHINA = Material.paint("china", .82, .82, .80);
    static final Material CLAY = Material.paint("clay", .55, .26, .15);
    static final Material SOIL = Material.paint("soil", .09, .06, .04);
    static final Material LEAF = Material.paint("leaf", .10, .30, .09).onBothSides();
    static final Material ORANGE = Material.paint("orange", .80, .36, .05);
    static final Material PAPER = Material.paint("paper", .82, .81, .76);
    static final Material MIDNIGHT = Material.paint("midnight", .07, .10, .22);
    static final Material SKY_BLUE = Material.paint("sky blue", .42, .56, .66);
    static final Material ROSE = Material.paint("rose", .76, .46, .38);

    /** The sky behind the window, from the horizon up, shortly after sunset. */
    static final Material[] SKY = {
        Material.lamp("sky 1", 1.80, .95, .57, .1), Material.lamp("sky 2", 1.50, .97, .78, .1),
        Material.lamp("sky 3", 1.12, .90, 1.0, .1), Material.lamp("sky 4", .77, .81, 1.18, .1),
        Material.lamp("sky 5", .55, .70, 1.25, .1), Material.lamp("sky 6", .38, .60, 1.25, .1)};
    static final Material OPAL = Material.lamp("opal glass", 50, 45, 37, .8);
    static final Material BULB = Material.lamp("bulb", 440, 378, 290, .8);
    /** Lets some of the bulb's light through, which a diffuse surface can only do by shining itself. */
    static final Material SHADE = new Material("lamp shade", 1, .85, .64, .75, 1.6, 3);
    static final Material DESK_BULB = Material.lamp("desk bulb", 540, 480, 390, .8);

    private Palette() {
    }
}
