package radiosity.viewer;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import radiosity.output.image.ToneMapping;
import radiosity.viewer.web.WebPage;

/** Takes the pictures of docs/VIEWER.md, which has the command. */
final class DocumentPictures {

    private static final int WIDTH = 560;
    private static final int HEIGHT = 480;
    private static final int GAP = 4;

    private DocumentPictures() { }

    /** @param arguments the scene file of the Cornell box, and the folder of the documents */
    public static void main(String[] arguments) throws Exception {
        Path docs = Path.of(arguments[1]);
        Path folder = Files.createTempDirectory("pictures");
        ImageIO.write(beside(2, window(Path.of(arguments[0]), folder)), "png", docs.resolve("viewer.png").toFile());
        Path lamps = TwoLamps.write(folder);
        ImageIO.write(beside(2, List.of(panel(lamps, folder), page(lamps, folder))), "png",
                docs.resolve("lamps.png").toFile());
        System.exit(0);
    }

    /** A probe, wireframe, false colour, the keys. */
    private static List<BufferedImage> window(Path scene, Path folder) throws IOException {
        try (DrivenWindow window = new DrivenWindow(scene, folder, WIDTH, HEIGHT)) {
            window.say("click 200 140");
            BufferedImage probe = window.shot("probe");
            window.tap("SPACE");
            window.tap("X");
            BufferedImage wires = window.shot("wires");
            window.tap("X");
            window.tap("C");
            BufferedImage colours = window.shot("colours");
            window.tap("C");
            window.tap("H");
            return List.of(probe, wires, colours, window.shot("keys"));
        }
    }

    /** The ceiling's lamp dim and warm, the blue light dimmer. */
    private static BufferedImage panel(Path scene, Path folder) throws IOException {
        try (DrivenWindow window = new DrivenWindow(scene, folder, WIDTH, HEIGHT)) {
            window.tap("P");
            window.say("set lamp0 60");
            window.say("colour 0 255 190 120");
            window.say("set lamp1 30");
            return window.screen("panel");
        }
    }

    /** The same on the web page. */
    private static BufferedImage page(Path scene, Path folder) throws Exception {
        try (WebPage page = new WebPage(scene, ToneMapping.Operator.REINHARD, 0, 0);
                Browser browser = new Browser(folder.resolve("profile"), HEIGHT)) {
            browser.open(page.address());
            browser.tap("KeyP", "p");
            browser.set("colour0", "#ffbe78");
            browser.set("lamp0", "60");
            browser.set("lamp1", "30");
            return browser.screenshot();
        }
    }

    /** Pictures in rows of so many. */
    private static BufferedImage beside(int columns, List<BufferedImage> pictures) {
        int width = pictures.stream().mapToInt(BufferedImage::getWidth).max().orElseThrow();
        int height = pictures.stream().mapToInt(BufferedImage::getHeight).max().orElseThrow();
        int rows = (pictures.size() + columns - 1) / columns;
        BufferedImage all = new BufferedImage(columns * (width + GAP) - GAP, rows * (height + GAP) - GAP,
                BufferedImage.TYPE_INT_RGB);
        Graphics2D g = all.createGraphics();
        for (int i = 0; i < pictures.size(); i++) {
            g.drawImage(pictures.get(i), i % columns * (width + GAP), i / columns * (height + GAP), null);
        }
        g.dispose();
        return all;
    }
}
