package radiosity.testkit;

import java.util.List;
import java.util.function.Supplier;

/**
 * A case that is calculated, and how exact that must be: held by tests, and printed by {@code scripts/extremes}.
 *
 * @param group   what cases like it have in common: a row of the table
 * @param name    of the case
 * @param figures calculates it
 */
public record Claim(String group, String name, Supplier<List<Figure>> figures) {

    /** With one figure. */
    public static Claim of(String group, String name, Supplier<Figure> figure) {
        return new Claim(group, name, () -> List.of(figure.get()));
    }

    /** Fails where one of the figures is larger than it may be. */
    public void check() {
        figures.get().forEach(figure -> figure.check(name));
    }

    @Override
    public String toString() {
        return name;
    }
}
