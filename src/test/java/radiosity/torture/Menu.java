package radiosity.torture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * What a campaign takes in turns.
 *
 * @param kinds  of scenes; one that is there twice comes twice as often
 * @param faults done to renders
 */
record Menu(List<SceneKind> kinds, List<Fault> faults) {

    /** Everything; the study, which takes a minute, half as often as the others. */
    static Menu all() {
        List<SceneKind> kinds = new ArrayList<>(small().kinds);
        kinds.addAll(small().kinds);
        kinds.add(SceneKind.STUDY);
        return new Menu(kinds, small().faults);
    }

    /** All that takes some seconds. */
    static Menu small() {
        return new Menu(Arrays.stream(SceneKind.values()).filter(kind -> kind != SceneKind.STUDY).toList(),
                List.of(Fault.values()));
    }

    static Menu of(SceneKind kind, Fault fault) {
        return new Menu(List.of(kind), List.of(fault));
    }

    /** One thing of a list, in turns of which each has an order of its own. */
    static <T> T turn(List<T> things, long seed, int index, int salt) {
        int turn = index / things.size();
        return new Dice(Dice.mixed(seed) + 1000L * turn + salt).shuffled(things).get(index % things.size());
    }
}
