package radiosity.viewer;

import java.awt.EventQueue;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.DoubleStream;
import radiosity.edit.Drag;
import radiosity.edit.Edit;
import radiosity.edit.EditFiles;
import radiosity.edit.EditHistory;
import radiosity.edit.EditSource;
import radiosity.edit.LightFollower;
import radiosity.edit.ObjectTriangles;
import radiosity.edit.Picked;
import radiosity.output.gltf.LitScene;
import radiosity.output.image.ToneMapping;
import radiosity.scene.Affine;
import radiosity.scene.Camera;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.SceneNode;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.solution.Solution;

/** Moves, turns and paints objects while the light follows; on the event thread, except where stated. */
final class Editing {

    private final Display display;
    private final Optional<Callable<EditSource>> wanted;
    private boolean isReading;
    private boolean isOn;
    private boolean isClosed;
    private EditFiles files;
    private EditHistory history;
    private LightFollower follower;
    /** Scene whose light is shown; null before the first picture. */
    private Scene shown;
    /** Scene whose light is being rendered or is at rest. */
    private Scene followed;
    /** Result of the last edit; null while its light is being rendered. */
    private LightFollower.Rest rest;
    private boolean savesAtRest;
    /** Whether files are being written; cleared on the event thread. */
    private boolean isSaving;
    private boolean isEdited;
    private boolean isSaved = true;
    private Thread saving;
    /** Hierarchy node and surface that are selected; -1 where nothing is. */
    private int node = -1;
    private int surface = -1;
    private boolean isFixed;
    /** The drag under way; null where the mouse holds no object. */
    private Drag drag;
    /** Edit of the drag under way, not yet in the history; null for none. */
    private Edit pending;
    private String line = "";
    /** Text about the latest edit, for the user. */
    private String done = "";

    Editing(Display display, Optional<Callable<EditSource>> wanted) {
        this.display = display;
        this.wanted = wanted;
    }

    /** Switches editing on or off; edits made so far remain. */
    void toggle() {
        if (wanted.isEmpty()) {
            display.status(List.of("edit: expected a scene file of RadiosityRenderer"));
        } else if (history != null) {
            isOn = !isOn;
            select(-1, -1);
            say(isOn ? "edit: click on an object" : "edit: ended (M goes on)");
        } else if (!isReading) {
            isReading = true;
            say("edit: reading what the scene file was made from");
            Thread reading = new Thread(this::read, "source");
            reading.setDaemon(true);
            reading.start();
        }
    }

    private void read() {
        try {
            EditSource source = wanted.get().call();
            EditFiles saved = new EditFiles(source);
            EventQueue.invokeLater(() -> begin(source, saved));
        } catch (Exception | OutOfMemoryError e) {
            EventQueue.invokeLater(() -> {
                isReading = false;
                say("edit: " + reason(e));
            });
        }
    }

    /** The message of a failure, or its name where it has none. */
    static String reason(Throwable e) {
        return e.getMessage() == null ? e.toString() : e.getMessage();
    }

    private void begin(EditSource source, EditFiles saved) {
        if (isClosed) {
            return;
        }
        files = saved;
        Camera camera = display.lighting().scene().camera();
        history = new EditHistory(source.scene());
        isOn = true;
        follower = new LightFollower(source.light(), source.settings(), Runtime.getRuntime().availableProcessors(),
                solution -> show(LitScene.of(solution, camera), solution),
                last -> EventQueue.invokeLater(() -> settle(last)),
                failure -> EventQueue.invokeLater(() -> say(failure)));
        follow(source.scene(), false);
    }

    /** Whether editing was ever on, so that the window no longer shows the scene file. */
    boolean hasBegun() {
        return history != null;
    }

    boolean isOn() {
        return isOn;
    }

    /** Shows a picture; called on the follower's thread, and returns when the picture is displayed. */
    private void show(LitScene lit, Solution solution) {
        try {
            EventQueue.invokeAndWait(() -> {
                if (!isClosed) {
                    boolean isFirst = shown == null;
                    shown = solution.scene();
                    display.follow(lit);
                    place();
                    if (isFirst) {
                        say("edit: click on an object, drag it (Shift: up and down, Ctrl: turn)"
                                + files.obstacle().map(why -> "; only scene files are saved; " + why).orElse(""));
                    } else if (isEdited && pending == null) {
                        say(done + String.format(Locale.ROOT, "; the light follows: %,d elements, %.1f %% to be"
                                + " distributed", solution.elements(), 100 * solution.unshotFlux()
                                / DoubleStream.of(solution.ledger().emitted()).sum()));
                    }
                }
            });
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (InvocationTargetException e) {
            throw new IllegalStateException("window: " + e.getCause().getMessage(), e);
        }
    }

    private void settle(LightFollower.Rest last) {
        if (isClosed || last.solution().scene() != followed) {
            return;
        }
        rest = last;
        display.settled();
        if (isEdited) {
            say(done + "; " + last.text());
        }
        if (savesAtRest) {
            save();
        }
    }

    /** The scene with all edits, the edit of the drag under way included. */
    private Scene scene() {
        return pending == null ? history.scene() : pending.of(history.scene());
    }

    private void follow(Scene scene, boolean isMoving) {
        rest = null;
        followed = scene;
        follower.follow(scene, isMoving);
    }

    /** Nodes of the selected object, which is drawn apart, and a box around them; null where nothing is selected. */
    SceneShapes.Selection selection() {
        return node < 0 || shown == null ? null
                : new SceneShapes.Selection(ObjectTriangles.nodes(shown, node), ObjectTriangles.box(shown, node));
    }

    /** Draws the selected object at its present position, in the light shown. */
    private void place() {
        if (node >= 0) {
            display.place(ObjectTriangles.between(shown, scene(), node));
        }
    }

    private void select(int object, int ofSurface) {
        boolean isOther = object != node;
        node = object;
        surface = ofSurface;
        isFixed = object >= 0 && Drag.isTooLarge(history.scene(), object);
        if (isOther && shown != null) {
            display.select();
            place();
        }
    }

    private Optional<Picked> picked(int x, int y) {
        return shown == null ? Optional.empty()
                : Picked.of(history.scene(), display.camera().position(), display.direction(x, y));
    }

    /** Selects the object under the mouse; where that object is selected already, its parent. */
    void click(int x, int y) {
        Optional<Picked> hit = picked(x, y);
        int object = hit.map(h -> history.scene().hierarchy().of(h.triangle())).orElse(-1);
        if (hit.isPresent() && object < 0) {
            say("edit: expected a scene of objects, got triangles that belong to none");
            return;
        }
        List<SceneNode> nodes = history.scene().hierarchy().nodes();
        if (object >= 0 && ObjectTriangles.nodes(history.scene(), node < 0 ? object : node)[object] && node >= 0) {
            object = nodes.get(node).parent() >= 0 ? nodes.get(node).parent() : object;
        }
        select(object, hit.map(h -> history.scene().surfaceOf()[h.triangle()]).orElse(-1));
        say(object < 0 ? "edit: nothing selected" : "");
    }

    /** Begins to drag the selected object where it is under the mouse; returns whether it is. */
    boolean grab(int x, int y) {
        Optional<Picked> hit = isOn && node >= 0 && !isFixed ? picked(x, y) : Optional.empty();
        int object = hit.map(h -> history.scene().hierarchy().of(h.triangle())).orElse(-1);
        boolean isHeld = object >= 0 && ObjectTriangles.nodes(history.scene(), node)[object];
        drag = isHeld ? new Drag(history.scene(), node, hit.get().point()) : null;
        return isHeld;
    }

    /** Moves the object being dragged by a number of pixels; does nothing after an undo has ended the drag. */
    void drag(Drag.Hand hand, int right, int down) {
        if (drag == null) {
            return;
        }
        drag.move(hand, right, down, display.camera(), display.height());
        isEdited = true;
        pending = drag.edit();
        place();
        follow(scene(), true);
        say(pending.text(history.scene()));
    }

    /** Ends the drag and makes it an edit. */
    void drop() {
        drag = null;
        if (pending != null) {
            put(pending);
        }
    }

    private void put(Edit edit) {
        pending = null;
        try {
            history.add(edit);
            isSaved = false;
            done = edit.text(history.scene());
            say(done + "; the light follows");
        } catch (IllegalArgumentException e) {
            say("edit: " + e.getMessage());
        }
        follow(history.scene(), false);
        place();
    }

    /** The surface that a chosen colour paints; null for none. */
    Surface painted() {
        return isOn && surface >= 0 ? (pending instanceof Edit.Painted ? scene() : history.scene()).surfaces()
                .get(surface) : null;
    }

    /** @param isMoving whether the user is still dragging the slider */
    void paint(Rgb reflectance, boolean isMoving) {
        if (surface < 0) {
            return;
        }
        Edit edit = new Edit.Painted(surface, reflectance);
        isEdited = true;
        if (isMoving) {
            try {
                Scene painted = edit.of(history.scene());
                pending = edit;
                follow(painted, true);
            } catch (IllegalArgumentException e) {
                say("edit: " + e.getMessage());
            }
        } else {
            put(edit);
        }
    }

    void undo() {
        if (history == null || !history.undo()) {
            display.status(List.of("edit: nothing to undo"));
            return;
        }
        pending = null;
        drag = null;
        follow(history.scene(), false);
        place();
        isSaved = history.edits().isEmpty();
        done = "undone, " + history.edits().size() + " left";
        say(done + "; the light follows");
    }

    /** Saves the edited scene, at once or when its light is at rest and files that are being written are complete. */
    void save() {
        savesAtRest = false;
        if (history == null || history.edits().isEmpty()) {
            display.status(List.of("edit: nothing to save"));
        } else if (rest == null || pending != null) {
            savesAtRest = true;
            say("edit: saved when the light is at rest");
        } else if (isSaving) {
            savesAtRest = true;
            say("edit: still saving");
        } else {
            isSaving = true;
            LightFollower.Rest saved = rest;
            say("edit: saving");
            List<Edit> edits = history.edits();
            ToneMapping toneMapping = display.lighting().toneMapping();
            saving = new Thread(() -> save(saved, toneMapping, edits), "save");
            saving.start();
        }
    }

    private void save(LightFollower.Rest saved, ToneMapping toneMapping, List<Edit> edits) {
        try {
            String outcome = files.save(saved, toneMapping);
            EventQueue.invokeLater(() -> {
                isSaved = edits.equals(history.edits());
                endSaving(outcome);
            });
        } catch (IOException | RuntimeException | OutOfMemoryError e) {
            EventQueue.invokeLater(() -> endSaving("edit: not saved: " + reason(e)));
        }
    }

    /** Saves again where the user asked for that during the saving that has ended, and not all edits are saved. */
    private void endSaving(String outcome) {
        isSaving = false;
        say(outcome);
        if (savesAtRest && !isSaved && !isClosed) {
            save();
        } else {
            savesAtRest = false;
        }
    }

    /** Whether closing the window would lose edits; warns the user, and returns true only once until the next edit. */
    boolean holdsBack() {
        boolean isHeld = !isSaved;
        if (isHeld) {
            isSaved = true;
            say("edit: not saved; Ctrl+S saves, Esc once more closes");
        }
        return isHeld;
    }

    private void say(String text) {
        line = text;
        display.status(lines());
    }

    private List<String> lines() {
        List<String> lines = new ArrayList<>(line.isEmpty() ? List.of() : List.of(line.split("; ")));
        if (node < 0) {
            return lines;
        }
        Surface of = painted();
        String selected = "selected     " + history.scene().hierarchy().nodes().get(node).name()
                + (isFixed ? " (too large to be dragged)" : "") + (of == null ? ""
                : String.format(Locale.ROOT, ", %s reflects %.3g  %.3g  %.3g", of.name(), of.reflectance().r(),
                of.reflectance().g(), of.reflectance().b()));
        lines.add(0, selected);
        return lines;
    }

    /** Ends editing; waits for files that are being written. */
    void close() {
        isClosed = true;
        try {
            if (saving != null) {
                saving.join();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        if (follower != null) {
            follower.close();
        }
    }
}
