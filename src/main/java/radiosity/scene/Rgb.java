package radiosity.scene;

/** One value for each of the three channels red, green and blue. */
public record Rgb(double r, double g, double b) {

    public static final Rgb BLACK = new Rgb(0, 0, 0);

    public static Rgb grey(double v) {
        return new Rgb(v, v, v);
    }

    /** @param channels 3 values, or a single one for a grey; not modified */
    public static Rgb of(double[] channels) {
        return channels.length == 1 ? grey(channels[0]) : new Rgb(channels[0], channels[1], channels[2]);
    }

    public Rgb times(double s) {
        return new Rgb(r * s, g * s, b * s);
    }

    public Rgb plus(Rgb v) {
        return new Rgb(r + v.r, g + v.g, b + v.b);
    }

    public Rgb times(Rgb v) {
        return new Rgb(r * v.r, g * v.g, b * v.b);
    }

    /** The value of one channel: 0 red, 1 green, 2 blue. */
    public double channel(int c) {
        return c == 0 ? r : c == 1 ? g : b;
    }

    /** The minimum of each channel and the given value. */
    public Rgb atMost(double most) {
        return new Rgb(Math.min(r, most), Math.min(g, most), Math.min(b, most));
    }

    public double max() {
        return Math.max(r, Math.max(g, b));
    }

    public boolean isGrey() {
        return r == g && g == b;
    }

    public boolean isFinite() {
        return Double.isFinite(r) && Double.isFinite(g) && Double.isFinite(b);
    }
}
