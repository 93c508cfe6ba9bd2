package radiosity.cli.options;

import radiosity.scene.Scene;

/**
 * The largest area of a patch as the user gives it ({@code -pa}).
 *
 * @param amount   above 0; square scene units, or per cent of the area of the scene
 * @param relative whether the amount is in per cent
 */
public record PatchArea(double amount, boolean relative) {

    /** The largest area of a patch in a scene, square scene units. */
    double in(Scene scene) {
        return relative ? amount / 100 * scene.area() : amount;
    }

    /** Parses {@code 1000} and {@code 0.5%}. */
    static final class Parser extends Values.Value<PatchArea> {
        @Override
        String expected() {
            return "a number above 0";
        }

        @Override
        public PatchArea parse(String text) {
            boolean relative = text.endsWith("%");
            double amount = Values.decimal(relative ? text.substring(0, text.length() - 1) : text);
            return amount > 0 && !(relative && amount > 100) ? new PatchArea(amount, relative) : null;
        }
    }
}
