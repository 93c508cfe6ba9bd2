package radiosity.worker;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import radiosity.mesh.PatchTree;
import radiosity.protocol.Shot;

/**
 * What everything in the scene has ever shot, as it follows from the orders: every host and the master keep it up to
 * date, so that it need not be sent when new vertices gather it.
 */
public final class ShotHistory {

    private final int channels;
    /** What has not shot is left out. */
    private final Map<Top, PatchTree> trees = new ConcurrentHashMap<>();

    private record Top(int face, long path) { }

    public ShotHistory(int channels) {
        this.channels = channels;
    }

    private static Top top(PatchTree tree) {
        return new Top(tree.face(), tree.path());
    }

    public boolean isEmpty() {
        return trees.isEmpty();
    }

    /** @param all what was shot instead of what is known here */
    public void set(List<Shot> all) {
        trees.clear();
        all.forEach(shot -> shot.trees().forEach(tree -> trees.put(top(tree), tree)));
    }

    /** All of it, by whatever shooters. */
    public List<Shot> all() {
        return isEmpty() ? List.of() : List.of(new Shot(List.copyOf(trees.values()), 0));
    }

    /** What is shot now. */
    public void add(List<Shot> shots) {
        shots.forEach(shot -> shot.trees().forEach(tree -> trees.merge(top(tree), tree, PatchTree::plus)));
    }

    /** What those have shot whose trees are these, on all of their elements. */
    List<Shot> of(List<Shot> shapes) {
        return shapes.stream().map(this::of).toList();
    }

    /** The same of one shooter. Any thread, as long as nothing is shot. */
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
