package radiosity.edit;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import radiosity.scene.Scene;

/** A scene with the edits made on it, which can be undone, the latest first. */
public final class EditHistory {

    private final Scene original;
    private final Deque<Scene> scenes = new ArrayDeque<>();
    private final List<Edit> edits = new ArrayList<>();

    public EditHistory(Scene original) {
        this.original = original;
        scenes.push(original);
    }

    /** The scene without edits. */
    public Scene original() {
        return original;
    }

    /** The scene with all edits. */
    public Scene scene() {
        return scenes.peek();
    }

    /** All edits that are not undone, the earliest first. */
    public List<Edit> edits() {
        return List.copyOf(edits);
    }

    /** Applies an edit; where {@link Edit#of} throws, the exception is passed on and nothing has changed. */
    public void add(Edit edit) {
        scenes.push(edit.of(scene()));
        edits.add(edit);
    }

    /** Undoes the latest edit; returns false where there is none. */
    public boolean undo() {
        if (edits.isEmpty()) {
            return false;
        }
        scenes.pop();
        edits.remove(edits.size() - 1);
        return true;
    }
}
