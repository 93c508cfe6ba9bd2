package radiosity.worker;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import radiosity.mesh.PatchTree;
import radiosity.protocol.Shot;

/**
 * The total radiosity that each shooter of the scene has shot so far, summed up from the orders. Every host and the
 * master keep this history, so that it need not be sent when new vertices gather all light ever shot.
 */
public final class ShotHistory {

    private final int channels;
    /** Total radiosity of the tree below each top node; a top node that has not shot may be left out. */
    private final Map<Shot.Place, PatchTree> trees = new ConcurrentHashMap<>();

    public ShotHistory(int channels) {
        this.channels = channels;
    }

    private static Shot.Place top(PatchTree tree) {
        return new Shot.Place(tree.face(), tree.path());
    }

    public boolean isEmpty() {
        return trees.isEmpty();
    }

    /** Replaces this history by the totals of all shooters. */
    public void set(List<Shot> all) {
        trees.clear();
        all.forEach(shot -> shot.trees().forEach(tree -> trees.put(top(tree), tree)));
    }

    /** All light ever shot, as one shot; an empty list where this history is empty. */
    public List<Shot> all() {
        return isEmpty() ? List.of() : List.of(new Shot(List.copyOf(trees.values()), 0));
    }

    /** Adds shots to the totals. */
    public void add(List<Shot> shots) {
        shots.forEach(shot -> shot.trees().forEach(tree -> trees.merge(top(tree), tree, PatchTree::plus)));
    }

    /** The totals of some shooters, on the elements of {@code shapes}, whose radiosities are not read. */
    List<Shot> of(List<Shot> shapes) {
        return shapes.stream().map(this::of).toList();
    }

    /**
     * The total of one shooter, on the elements of {@code shape}; called by any thread while no shots are added. The
     * shooter is kept as it is divided, also before it has shot: later shots are then added at the corners of its
     * elements, as partitions add them, and the bits are the same.
     */
    public Shot of(Shot shape) {
        return new Shot(shape.trees().stream().map(this::keep).toList(), shape.flux());
    }

    private PatchTree keep(PatchTree shape) {
        PatchTree now = divided(shape);
        trees.put(top(shape), now);
        return now;
    }

    private PatchTree divided(PatchTree shape) {
        PatchTree known = trees.get(top(shape));
        return (known == null ? PatchTree.none(shape.face(), shape.path(), channels) : known).divided(shape.child());
    }
}
