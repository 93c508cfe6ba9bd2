package radiosity.scenes;

import java.util.Map;
import java.util.TreeMap;
import radiosity.scenes.SceneText.Place;

/**
 * A furnished study at dusk, in metres: a window, a ceiling lamp, a floor lamp and a desk lamp.
 *
 * <p>Objects lie in the folder study; the scene places them, some several times, some as parts of others.
 */
final class Study {

    private final SceneText scene = new SceneText();

    private Study() {
    }

    /** Content of each file by its path below {@code scenes}. */
    static Map<String, byte[]> files() {
        Map<String, byte[]> files = new TreeMap<>();
        files.put("study.lws", new Study().text());
        files.put("study/room.lwo", StudyRoom.object());
        files.put("study/curtain.lwo", StudyRoom.curtain());
        files.put("study/sofa.lwo", Seats.upholstered(2.3, 2, Palette.RUST));
        files.put("study/armchair.lwo", Seats.upholstered(1.0, 1, Palette.MUSTARD));
        files.put("study/pillow-cream.lwo", Seats.pillow(Palette.CREAM));
        files.put("study/pillow-teal.lwo", Seats.pillow(Palette.TEAL));
        files.put("study/chair.lwo", Seats.chair());
        files.put("study/coffee-table.lwo", Tables.coffeeTable());
        files.put("study/desk.lwo", Tables.desk());
        files.put("study/tableware.lwo", Tables.tableware());
        files.put("study/rug.lwo", Tables.rug());
        files.put("study/shelf.lwo", Shelf.object());
        files.put("study/pictures.lwo", Decor.pictures());
        files.put("study/plant.lwo", Decor.plant());
        files.put("study/pendant.lwo", Lamps.pendant());
        files.put("study/floor-lamp.lwo", Lamps.floorLamp());
        files.put("study/desk-lamp.lwo", Lamps.deskLamp());
        return files;
    }

    private byte[] text() {
        room();
        sittingCorner();
        workingCorner();
        pictures();
        return scene.seenFrom(Place.at(1.15, 1.42, 0.15).turned(-10).tilted(3), 2.0, 1280, 720);
    }

    private void room() {
        for (int layer = 1; layer <= 2; layer++) {
            put("room", layer, Place.at(0, 0, 0));
        }
        put("curtain", 1, Place.at(-2.9, 0, 2.1).turned(-90));
        put("curtain", 1, Place.at(-2.9, 0, 5.1).turned(-90).mirrored());
        put("pendant", 1, Place.at(-0.35, 2.7, 3.3));
    }

    private void sittingCorner() {
        Area rug = StudyRoom.RUG;
        put("rug", 1, Place.at((rug.u0() + rug.u1()) / 2, 0, (rug.v0() + rug.v1()) / 2));
        int sofa = put("sofa", 1, Place.at(-0.40, 0, 4.98));
        for (int side = -1; side <= 1; side += 2) {
            part("sofa", 2, Place.at(side * 0.475, 0.462, 0.135).tilted(9), sofa);
        }
        part("pillow-cream", 1, Place.at(-0.66, 0.465, -0.13).turned(22).tilted(14), sofa);
        part("pillow-teal", 1, Place.at(0.64, 0.465, -0.13).turned(-25).tilted(14), sofa);
        int armchair = put("armchair", 1, Place.at(-2.05, 0, 3.45).turned(-65));
        part("armchair", 2, Place.at(0, 0.462, 0.135).tilted(9), armchair);
        int table = put("coffee-table", 1, Place.at(-0.35, 0.012, 3.30));
        part("tableware", 1, Place.at(0.10, 0.40, 0.12), table);
        part("tableware", 4, Place.at(-0.18, 0.40, -0.05).turned(25), table);
        put("floor-lamp", 1, Place.at(1.12, 0, 5.05));
        put("floor-lamp", 2, Place.at(1.12, 0, 5.05));
        put("plant", 1, Place.at(-2.35, 0, 5.0));
    }

    private void workingCorner() {
        int shelf = put("shelf", 1, Place.at(2.15, 0, 5.58));
        part("shelf", 2, Place.at(0, 0, 0), shelf);
        part("tableware", 2, Place.at(-0.32, 1.272, -0.17), shelf);
        int desk = put("desk", 1, Place.at(2.62, 0, 3.55).turned(90));
        put("chair", 1, Place.at(2.05, 0, 3.6).turned(-100));
        part("tableware", 3, Place.at(-0.12, 0.75, 0.18), desk);
        part("tableware", 5, Place.at(0.0, 0.75, -0.10).turned(-8), desk);
        part("tableware", 4, Place.at(0.45, 0.75, 0.12).turned(80), desk);
        deskLamp(desk);
    }

    /** Each arm is a part of the one before, placed at its joint and turned about it. */
    private void deskLamp(int desk) {
        int foot = part("desk-lamp", 1, Place.at(-0.45, 0.75, 0.16).turned(140), desk);
        int lower = part("desk-lamp", 2, Place.at(0, 0.038, 0).tilted(-25), foot);
        int upper = part("desk-lamp", 3, Place.at(0, 0.40, 0).tilted(80), lower);
        part("desk-lamp", 4, Place.at(0, 0.78, 0).tilted(105), upper);
    }

    private void pictures() {
        for (Decor.Hung picture : Decor.BACK_WALL) {
            put("pictures", picture.layer(), Place.at(picture.along(), picture.height(), StudyRoom.BACK));
        }
        for (Decor.Hung picture : Decor.RIGHT_WALL) {
            put("pictures", picture.layer(), Place.at(StudyRoom.RIGHT, picture.height(), picture.along()).turned(90));
        }
    }

    private int put(String object, int layer, Place place) {
        return scene.instance("study/" + object + ".lwo", layer, place);
    }

    private int part(String object, int layer, Place place, int parent) {
        return scene.instance("study/" + object + ".lwo", layer, place, parent);
    }
}
