package radiosity.extremes;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import radiosity.accuracy.CieTest;
import radiosity.accuracy.Claim;
import radiosity.accuracy.EnclosuresTest;
import radiosity.accuracy.FaceSystemTest;
import radiosity.accuracy.Figure;
import radiosity.accuracy.FormFactorsTest;

/** Prints the worst of every group of cases that tests hold, with more of them: {@code scripts/extremes}. */
public final class ExtremesTable {

    private static final int POLYHEDRA = 50;
    private static final double ACCURACY = 3e-3;

    /** The worst figure of a group so far. */
    private record Worst(int cases, Figure figure, String name) {

        Worst and(Figure other, String of) {
            boolean worse = !(other.reached() <= figure.reached());
            return new Worst(cases + 1, worse ? other : figure, worse ? of : name);
        }
    }

    private ExtremesTable() { }

    public static void main(String[] arguments) {
        Locale.setDefault(Locale.ROOT);
        System.out.println("| case | cases | of what | asked | reached | worst |\n|---|---|---|---|---|---|");
        boolean holds = true;
        for (Stream<Claim> claims : all()) {
            Map<List<String>, Worst> worst = new LinkedHashMap<>();
            claims.forEach(claim -> claim.figures().get().forEach(figure -> worst.merge(
                    List.of(claim.group(), figure.what()), new Worst(1, figure, claim.name()),
                    (before, now) -> before.and(figure, claim.name()))));
            worst.forEach(ExtremesTable::print);
            holds &= worst.values().stream().allMatch(w -> w.figure().holds());
        }
        if (!holds) {
            System.err.println("extremes: expected what is asked, got more in some");
            System.exit(1);
        }
    }

    private static List<Stream<Claim>> all() {
        return List.of(WhiteFurnaceTest.claims(POLYHEDRA), CieTest.claims(), FormFactorsTest.contour(),
                FormFactorsTest.rayCaster(), EnclosuresTest.furnaces(), FaceSystemTest.claims(),
                EnclosuresTest.continuous(ACCURACY), ScaleAndPlaceTest.claims(), DynamicRangeTest.claims(),
                EmissionTest.claims(), GeometryTest.claims(), ParametersTest.claims(), PropertiesTest.claims());
    }

    private static void print(List<String> of, Worst worst) {
        Figure figure = worst.figure();
        System.out.printf("| %s | %d | %s | %s | %s%s | %s |%n", of.get(0), worst.cases(), of.get(1),
                Double.isInfinite(figure.asked()) ? "-" : number(figure.asked()), number(figure.reached()),
                figure.holds() ? "" : " **not held**", figure.reached() == 0 ? "-" : worst.name());
    }

    private static String number(double value) {
        return value == 0 ? "0" : String.format("%.1e", value);
    }
}
