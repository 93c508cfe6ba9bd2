package radiosity.bench;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Stream;
import radiosity.accuracy.CieTest;
import radiosity.accuracy.EnclosuresTest;
import radiosity.accuracy.FaceSystemTest;
import radiosity.accuracy.FormFactorsTest;
import radiosity.extremes.DynamicRangeTest;
import radiosity.extremes.EmissionTest;
import radiosity.extremes.GeometryTest;
import radiosity.extremes.ParametersTest;
import radiosity.extremes.PropertiesTest;
import radiosity.extremes.ScaleAndPlaceTest;
import radiosity.extremes.WhiteFurnaceTest;
import radiosity.testkit.Claim;
import radiosity.testkit.Figure;

/** Prints the worst of every group of cases that tests hold, with more of them: {@code scripts/extremes}. */
public final class ExtremesTable {

    private static final int POLYHEDRA = 50;
    private static final double ACCURACY = 3e-3;
    private static final String COST = "cost";

    /** The worst figure of a group so far. */
    private record Worst(int cases, Figure figure, String name) {

        Worst and(Figure other, String of) {
            boolean worse = !(other.reached() <= figure.reached());
            return new Worst(cases + 1, worse ? other : figure, worse ? of : name);
        }
    }

    private ExtremesTable() { }

    /** @param arguments topics, all without; {@code cost} is one that is no case */
    public static void main(String[] arguments) {
        Locale.setDefault(Locale.ROOT);
        Map<String, Supplier<Stream<Claim>>> cases = cases();
        List<String> topics = arguments.length == 0 ? List.copyOf(cases.keySet()) : List.of(arguments);
        boolean cost = topics.contains(COST);
        if (topics.stream().anyMatch(topic -> !cases.containsKey(topic) && !topic.equals(COST))) {
            System.err.println("extremes: expected " + COST + " or some of " + cases.keySet() + ", got " + topics);
            System.exit(2);
        }
        boolean holds = topics.equals(List.of(COST))
                || print(topics.stream().filter(cases::containsKey).map(cases::get));
        if (cost || arguments.length == 0) {
            System.out.println();
            WhiteCost.print();
        }
        if (!holds) {
            System.err.println("extremes: expected what is asked, got more in some");
            System.exit(1);
        }
    }

    /** Whether all hold. */
    private static boolean print(Stream<Supplier<Stream<Claim>>> cases) {
        System.out.println("| case | cases | of what | asked | reached | worst |\n|---|---|---|---|---|---|");
        boolean holds = true;
        for (Supplier<Stream<Claim>> some : cases.toList()) {
            Map<List<String>, Worst> worst = new LinkedHashMap<>();
            some.get().forEach(claim -> claim.figures().get().forEach(figure -> worst.merge(
                    List.of(claim.group(), figure.what()), new Worst(1, figure, claim.name()),
                    (before, now) -> before.and(figure, claim.name()))));
            worst.forEach(ExtremesTable::print);
            holds &= worst.values().stream().allMatch(w -> w.figure().holds());
        }
        return holds;
    }

    private static Map<String, Supplier<Stream<Claim>>> cases() {
        Map<String, Supplier<Stream<Claim>>> cases = new LinkedHashMap<>();
        cases.put("furnaces", () -> WhiteFurnaceTest.claims(POLYHEDRA));
        cases.put("cie", CieTest::claims);
        cases.put("form-factors", () -> Stream.concat(FormFactorsTest.contour(), FormFactorsTest.rayCaster()));
        cases.put("enclosures", () -> Stream.of(EnclosuresTest.furnaces(), FaceSystemTest.claims(),
                EnclosuresTest.continuous(ACCURACY)).flatMap(claims -> claims));
        cases.put("scale", ScaleAndPlaceTest::claims);
        cases.put("range", () -> Stream.concat(DynamicRangeTest.claims(), EmissionTest.claims()));
        cases.put("meshes", GeometryTest::claims);
        cases.put("settings", ParametersTest::claims);
        cases.put("laws", PropertiesTest::claims);
        return cases;
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
