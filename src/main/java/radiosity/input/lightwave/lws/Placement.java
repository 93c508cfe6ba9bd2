package radiosity.input.lightwave.lws;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import radiosity.input.file.Diagnostics;
import radiosity.scene.Affine;

/**
 * Places the items of a scene at a point in time.
 *
 * <p>{@code W = W(parent) T(position) R(pivot rotation) Ry(h) Rx(p) Rz(b) S T(-pivot)}; W(parent) includes the parent's
 * own T(-pivot), so a child's position is in the space of the parent's points. An item with a target is turned towards
 * it, whatever its heading, pitch and pivot rotation.
 */
public final class Placement {

    private static final long ROOT_MASK = 0xF0000000L;
    private static final long OBJECT_OF_BONE = 0xFFFF;
    /** Largest number of items each of which is aimed at the next, or at what that turns. */
    private static final int MOST_TARGETS = 100;

    private final SceneDescription scene;
    private final Motion.Instant instant;
    private final Diagnostics notes;
    private final Map<SceneItem, double[]> layerPivots = new IdentityHashMap<>();
    private final Map<SceneItem, Optional<SceneItem>> parents = new IdentityHashMap<>();
    private final Map<SceneItem, Affine> worlds = new IdentityHashMap<>();
    /** The items that are being turned towards their targets: an item may itself place the target it is aimed at. */
    private final Map<SceneItem, Boolean> aiming = new IdentityHashMap<>();
    private final Map<Long, SceneItem> byId = new HashMap<>();
    private final Map<SceneItem.Kind, List<SceneItem>> byKind = new HashMap<>();

    public Placement(SceneDescription scene, Motion.Instant instant, Diagnostics notes) {
        this.scene = scene;
        this.instant = instant;
        this.notes = notes;
        for (SceneItem.Kind kind : SceneItem.Kind.values()) {
            byKind.put(kind, scene.items(kind));
        }
        for (SceneItem item : scene.items) {
            if (item.id >= 0 && byId.putIfAbsent(item.id, item) != null) {
                notes.note(item.place(), "two items have the same identity, the first counts",
                        Long.toHexString(item.id));
            }
        }
    }

    /** Sets the pivot of an object's layer, used if the scene names no pivot; to be called before {@link #world}. */
    public void layerPivot(SceneItem object, double[] pivot) {
        layerPivots.put(object, pivot);
    }

    /** Map from an item's own space to the scene's. */
    public Affine world(SceneItem item) {
        Deque<SceneItem> chain = new ArrayDeque<>();
        Map<SceneItem, Boolean> inChain = new IdentityHashMap<>();
        SceneItem link = item;
        while (link != null && !worlds.containsKey(link)) {
            if (inChain.put(link, true) != null) {
                notes.note(link.place(), "parents form a circle, which is opened here");
                break;
            }
            chain.push(link);
            link = parent(link);
        }
        Affine world = link == null || !worlds.containsKey(link) ? Affine.IDENTITY : worlds.get(link);
        for (SceneItem next : chain) {
            world = world.times(local(next));
            worlds.put(next, world);
        }
        return world;
    }

    /** Map from the space of an item's position to the scene's: the parent's world, or the identity. */
    Affine parentWorld(SceneItem item) {
        SceneItem parent = parent(item);
        return parent == null || parent == item ? Affine.IDENTITY : world(parent);
    }

    /** Map from an item's own space to its parent's. */
    public Affine local(SceneItem item) {
        double[] pivot = pivot(item);
        return item.motion.position(instant).times(aimed(item).orElseGet(() -> turned(item)))
                .times(item.motion.scale(instant)).times(Affine.move(-pivot[0], -pivot[1], -pivot[2]));
    }

    private Affine turned(SceneItem item) {
        Affine rotation = item.motion.rotation(instant);
        if (!item.has("PivotRotation")) {
            return rotation;
        }
        double[] r = item.numbers("PivotRotation", instant, 0, 0, 0);
        return Turn.of(Math.toRadians(r[0]), Math.toRadians(r[1]), Math.toRadians(r[2])).times(rotation);
    }

    /**
     * The rotation of an item that is aimed at a target: the target determines heading and pitch, bank is kept. Empty
     * without a target, and where the target is at the item's own place.
     */
    private Optional<Affine> aimed(SceneItem item) {
        SceneItem target = target(item);
        if (target == null || target == item || aiming.containsKey(item)) {
            return Optional.empty();
        }
        if (aiming.size() >= MOST_TARGETS) {
            notes.note(item.place(), "items are not turned towards targets that long chains of targets turn");
            return Optional.empty();
        }
        aiming.put(item, true);
        Affine parent = parentWorld(item);
        double[] at = position(target);
        aiming.remove(item);
        double[] own = item.motion.position(instant).m();
        double[] d = new double[3];
        for (int k = 0; k < 3; k++) {
            d[k] = at[k] - parent.point(k, own[3], own[7], own[11]);
        }
        d = parent.unturn(d);
        double flat = StrictMath.hypot(d[0], d[2]);
        return !(flat + Math.abs(d[1]) > 0) || !Double.isFinite(flat + d[1]) ? Optional.empty()
                : Optional.of(Turn.of(StrictMath.atan2(d[0], d[2]), -StrictMath.atan2(d[1], flat),
                        item.motion.bank(instant)));
    }

    private double[] pivot(SceneItem item) {
        double[] none = layerPivots.getOrDefault(item, new double[3]);
        return item.numbers(item.either("PivotPosition", "PivotPoint"), instant, none);
    }

    /** Position of an item's pivot in the scene; 3 numbers. */
    double[] position(SceneItem item) {
        double[] pivot = pivot(item);
        Affine world = world(item);
        return new double[] {world.point(0, pivot[0], pivot[1], pivot[2]), world.point(1, pivot[0], pivot[1], pivot[2]),
            world.point(2, pivot[0], pivot[1], pivot[2])};
    }

    /** The item's parent; null if it has none. */
    public SceneItem parent(SceneItem item) {
        return parents.computeIfAbsent(item, i -> Optional.ofNullable(i.has("ParentItem")
                ? byReference(i, "ParentItem") : byNumber(i, "ParentObject"))).orElse(null);
    }

    /** The item at which an item is aimed; null if there is none. */
    SceneItem target(SceneItem item) {
        return item.has("TargetItem") ? byReference(item, "TargetItem") : byNumber(item, "TargetObject");
    }

    /** Finds an object by its number, as in LWSC 1 and 2: objects and null objects are counted together from 1. */
    private SceneItem byNumber(SceneItem item, String keyword) {
        String text = item.text(keyword);
        if (text.isEmpty()) {
            return null;
        }
        long number = SceneNumbers.whole(text, 10);
        List<SceneItem> objects = byKind.get(SceneItem.Kind.OBJECT);
        if (number >= 1 && number <= objects.size()) {
            return objects.get((int) number - 1);
        }
        return number == 0 ? null : missing(item, keyword, text);
    }

    /**
     * Finds an item by a hexadecimal reference. The first digit is the item's kind; the others are its identity in LWSC
     * 4 and later, and its index among the items of its kind before that.
     */
    private SceneItem byReference(SceneItem item, String keyword) {
        long reference = SceneNumbers.whole(item.text(keyword), 16);
        if (reference < 0 || reference > 0xFFFFFFFFL) {
            return missing(item, keyword, item.text(keyword));
        }
        SceneItem.Kind kind = kind(reference >>> 28);
        long number = reference & ~ROOT_MASK;
        if (kind == SceneItem.Kind.BONE) {
            kind = SceneItem.Kind.OBJECT;
            number &= OBJECT_OF_BONE;
        }
        SceneItem found = kind == null ? null : find(kind, number);
        return found == null ? missing(item, keyword, item.text(keyword)) : found;
    }

    private static SceneItem.Kind kind(long digit) {
        for (SceneItem.Kind kind : SceneItem.Kind.values()) {
            if (kind.digit == digit) {
                return kind;
            }
        }
        return null;
    }

    private SceneItem find(SceneItem.Kind kind, long number) {
        if (scene.version >= SceneDescription.WITH_IDENTITIES) {
            return byId.get((long) kind.digit << 28 | number);
        }
        List<SceneItem> all = byKind.get(kind);
        return number < all.size() ? all.get((int) number) : null;
    }

    private SceneItem missing(SceneItem item, String keyword, String text) {
        notes.note(item.place(), keyword + " names an item that does not exist", text);
        return null;
    }
}
