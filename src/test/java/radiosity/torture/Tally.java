package radiosity.torture;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/** How often each kind of scene, option and fault was there, and what was found; for several threads. */
final class Tally {

    private final Map<String, Map<String, Integer>> counts = new LinkedHashMap<>();
    /** Absorbed and escaped flux by emitted, of scenes of a kind. */
    private final Map<String, List<Double>> energy = new TreeMap<>();
    private final List<String> notes = new ArrayList<>();

    /** A kind of thing, and all that it may be: what never comes is counted as 0. */
    synchronized void expect(String what, Collection<String> names) {
        for (String name : names) {
            counts.computeIfAbsent(what, w -> new LinkedHashMap<>()).putIfAbsent(name, 0);
        }
    }

    synchronized void count(String what, String name) {
        counts.computeIfAbsent(what, w -> new LinkedHashMap<>()).merge(name, 1, Integer::sum);
    }

    synchronized int of(String what, String name) {
        return counts.getOrDefault(what, Map.of()).getOrDefault(name, 0);
    }

    synchronized void energy(String what, double found) {
        energy.computeIfAbsent(what, w -> new ArrayList<>()).add(found);
    }

    /** Something to be said at the end, once. */
    synchronized void note(String line) {
        if (!notes.contains(line)) {
            notes.add(line);
        }
    }

    /** What was expected and never came. */
    synchronized List<String> missing() {
        List<String> missing = new ArrayList<>();
        counts.forEach((what, names) -> names.forEach((name, count) -> {
            if (count == 0) {
                missing.add(what + " " + name);
            }
        }));
        return missing;
    }

    synchronized void print(PrintStream out) {
        counts.forEach((what, names) -> {
            out.println();
            out.println(what);
            names.forEach((name, count) -> out.printf(Locale.ROOT, "  %-24s %6d%n", name, count));
        });
        out.println();
        out.println("absorbed and escaped flux, of emitted       most   renders   above " + Energy.MOST);
        energy.forEach((what, found) -> out.printf(Locale.ROOT, "  %-36s %9.4g %9d %9d%n", what,
                Collections.max(found), found.size(), found.stream().filter(x -> x > Energy.MOST).count()));
        notes.forEach(line -> out.println(line));
    }
}
