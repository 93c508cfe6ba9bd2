package radiosity.edit;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import radiosity.scene.Scene;

/** A scene with the edits that were put on it, which can be taken off again, the latest first. */
public final class EditHistory {

    private final Scene original;
    private final Deque<Scene> scenes = new ArrayDeque<>();
    private final List<Edit> edits = new ArrayList<>();

    public EditHistory(Scene original) {
        this.original = original;
        scenes.push(original);
    }

    /** As it was read. */
    public Scene original() {
        return original;
    }

    /** With all edits. */
    public Scene scene() {
        return scenes.peek();
    }

    /** All edits, in their order. */
    public List<Edit> edits() {
        return List.copyOf(edits);
    }

    /** Puts an edit on; see {@link Edit#of} for what is thrown, whereupon nothing has changed. */
    public void add(Edit edit) {
        scenes.push(edit.of(scene()));
        edits.add(edit);
    }

    /** Takes the latest edit off; whether there was one. */
    public boolean undo() {
        if (edits.isEmpty()) {
            return false;
        }
        scenes.pop();
        edits.remove(edits.size() - 1);
        return true;
    }
}
