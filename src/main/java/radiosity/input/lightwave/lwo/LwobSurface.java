package radiosity.input.lightwave.lwo;

import radiosity.input.file.ByteReader;
import radiosity.input.file.Diagnostics;
import radiosity.scene.Rgb;

/** Reads the SURF chunk of LWOB and LWLO objects. */
final class LwobSurface {

    private static final int SMOOTH = 0x4;
    private static final int TWO_SIDED = 0x100;
    /** LightWave's smoothing angle where the file gives none, radians: right angles stay sharp. */
    private static final double USUAL_SMOOTHING = StrictMath.toRadians(89.5);

    private final Diagnostics notes;
    private SurfaceValues surface;
    private TextureBlock texture;
    /** Null where the file has no flags. */
    private Boolean smooth;
    private double floatDiffuse = Double.NaN;
    private double floatLuminosity = Double.NaN;
    private double floatSpecular = Double.NaN;
    private double floatTransparency = Double.NaN;
    private double floatReflection = Double.NaN;

    LwobSurface(Diagnostics notes) {
        this.notes = notes;
    }

    SurfaceValues read(ByteReader data) {
        surface = new SurfaceValues(data.s0(), "");
        Chunks chunks = new Chunks(data, 2, notes);
        while (chunks.next()) {
            value(chunks.id(), chunks.data());
            if (chunks.data().ranOut()) {
                notes.note(chunks.place(), "a value is cut short");
            }
        }
        finish();
        return surface;
    }

    private void value(String id, ByteReader data) {
        switch (id) {
            case "COLR" -> surface.colour = new Rgb(data.u1() / 255.0, data.u1() / 255.0, data.u1() / 255.0);
            case "FLAG" -> flags(data.u2());
            case "SMAN" -> surface.smoothing = (double) data.f4();
            case "DIFF" -> surface.diffuse = share(data);
            case "LUMI" -> surface.luminosity = share(data);
            case "SPEC" -> surface.specular = share(data);
            case "TRAN" -> surface.transparency = share(data);
            case "REFL" -> surface.reflection = share(data);
            case "RIND" -> surface.refraction = (double) data.f4();
            case "GLOS" -> surface.glossiness = glossiness(data.i2());
            case "VRFL" -> floatReflection = data.f4();
            case "VDIF" -> floatDiffuse = data.f4();
            case "VLUM" -> floatLuminosity = data.f4();
            case "VSPC" -> floatSpecular = data.f4();
            case "VTRN" -> floatTransparency = data.f4();
            default -> LwobTexture.value(this, id, data);
        }
    }

    private void flags(int flags) {
        surface.twoSided = (flags & TWO_SIDED) != 0;
        smooth = (flags & SMOOTH) != 0;
    }

    /** A share stored as an integer in units of 1/256; some programs wrote 4 bytes instead of 2. */
    private static double share(ByteReader data) {
        return (data.left() == 4 ? (int) data.u4() : data.i2()) / 256.0;
    }

    /** Glossiness of newer objects from a highlight's exponent (16 to 1024), which is 2^(10 glossiness + 2). */
    private static double glossiness(int exponent) {
        return (StrictMath.log(Math.max(4, exponent)) / StrictMath.log(2) - 2) / 10;
    }

    /** Floating-point values take precedence over integer values; the smoothing angle counts if its flag is set. */
    private void finish() {
        if (smooth != null) {
            surface.smoothing = !smooth ? Double.valueOf(0)
                    : surface.smoothing == null ? Double.valueOf(USUAL_SMOOTHING) : surface.smoothing;
        }
        surface.diffuse = either(floatDiffuse, surface.diffuse);
        surface.luminosity = either(floatLuminosity, surface.luminosity);
        surface.specular = either(floatSpecular, surface.specular);
        surface.transparency = either(floatTransparency, surface.transparency);
        surface.reflection = either(floatReflection, surface.reflection);
    }

    private static Double either(double precise, Double coarse) {
        return Double.isNaN(precise) ? coarse : Double.valueOf(precise);
    }

    /** Starts the description of an image or a pattern; the chunks that follow fill it. */
    void startTexture(String channel) {
        texture = new TextureBlock();
        texture.channel = channel;
        surface.addTexture(texture);
    }

    /** The texture whose description was started last; null before the first. */
    TextureBlock texture() {
        return texture;
    }
}
