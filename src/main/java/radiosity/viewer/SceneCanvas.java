package radiosity.viewer;

import java.awt.GraphicsConfiguration;
import java.awt.image.BufferedImage;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicReference;
import org.jogamp.java3d.Appearance;
import org.jogamp.java3d.Canvas3D;
import org.jogamp.java3d.GeometryArray;
import org.jogamp.java3d.ImageComponent;
import org.jogamp.java3d.ImageComponent2D;
import org.jogamp.java3d.PointArray;
import org.jogamp.java3d.Raster;
import org.jogamp.java3d.Shape3D;
import org.jogamp.vecmath.Point3f;

/** Canvas on which Java 3D draws the scene. It draws an overlay over each picture and returns copies of pictures. */
public final class SceneCanvas extends Canvas3D {

    /**
     * Shape without visible points or shader: drawn first, so that Java 3D draws the overlay without the scene's
     * shader.
     */
    private final Shape3D plain = new Shape3D(new PointArray(1, GeometryArray.COORDINATES), new Appearance());
    private volatile BufferedImage overlay;
    private final AtomicReference<CompletableFuture<BufferedImage>> wanted = new AtomicReference<>();

    SceneCanvas(GraphicsConfiguration configuration) {
        super(configuration);
    }

    /** @param image drawn over the scene from the upper left corner, not modified afterwards; null for no overlay */
    void overlay(BufferedImage image) {
        overlay = image;
    }

    /** Returns a copy of the next picture; the caller must make sure that a picture is drawn. */
    public CompletableFuture<BufferedImage> next() {
        return wanted.updateAndGet(old -> old == null ? new CompletableFuture<>() : old);
    }

    /** Called by Java 3D when the scene is drawn and not yet displayed. */
    @Override
    public void postRender() {
        BufferedImage text = overlay;
        if (text != null) {
            getGraphicsContext3D().draw(plain);
            getGraphics2D().drawAndFlushImage(text, 0, 0, this);
        }
        CompletableFuture<BufferedImage> copy = wanted.getAndSet(null);
        if (copy != null) {
            copy.complete(read());
        }
    }

    private BufferedImage read() {
        BufferedImage image = new BufferedImage(getWidth(), getHeight(), BufferedImage.TYPE_INT_RGB);
        Raster raster = new Raster(new Point3f(), Raster.RASTER_COLOR, 0, 0, getWidth(), getHeight(),
                new ImageComponent2D(ImageComponent.FORMAT_RGB, image), null);
        getGraphicsContext3D().readRaster(raster);
        return raster.getImage().getImage();
    }
}
