package radiosity.input.lightwave.lwo;

import radiosity.input.file.ByteReader;
import radiosity.scene.ImageMap.Wrap;

/**
 * Reads the texture chunks inside a SURF chunk of LWOB and LWLO objects: each xTEX chunk starts a texture, and the
 * chunks up to the next xTEX describe the texture.
 */
final class LwobTexture {

    private static final int WORLD = 8;
    private static final int NEGATIVE = 16;

    private LwobTexture() {
    }

    /** Reads one chunk if it belongs to a texture; ignores other chunks. */
    static void value(LwobSurface surface, String id, ByteReader data) {
        switch (id) {
            case "CTEX" -> start(surface, "COLR", data);
            case "DTEX" -> start(surface, "DIFF", data);
            case "LTEX" -> start(surface, "LUMI", data);
            case "STEX", "TTEX", "RTEX", "BTEX" -> start(surface, id, data);
            default -> {
                if (surface.texture() != null) {
                    describe(surface.texture(), id, data);
                }
            }
        }
    }

    private static void start(LwobSurface surface, String channel, ByteReader data) {
        surface.startTexture(channel);
        String kind = data.s0();
        surface.texture().projection = switch (kind) {
            case "Planar Image Map" -> TextureBlock.Projection.PLANAR;
            case "Cylindrical Image Map" -> TextureBlock.Projection.CYLINDRICAL;
            case "Spherical Image Map" -> TextureBlock.Projection.SPHERICAL;
            case "Cubic Image Map" -> TextureBlock.Projection.CUBIC;
            case "Front Projection Image Map" -> TextureBlock.Projection.FRONT;
            default -> TextureBlock.Projection.PLANAR;
        };
    }

    private static void describe(TextureBlock texture, String id, ByteReader data) {
        switch (id) {
            case "TIMG" -> texture.image = data.s0();
            case "TFLG" -> flags(texture, data.u2());
            case "TSIZ" -> texture.size = vector(data);
            case "TCTR" -> texture.centre = vector(data);
            case "TWRP" -> wrap(texture, data);
            case "TFP0" -> texture.turns[0] = data.f4();
            case "TFP1" -> texture.turns[1] = data.f4();
            case "TOPC" -> texture.opacity = data.f4();
            default -> { }
        }
    }

    private static void flags(TextureBlock texture, int flags) {
        texture.axis = (flags & 1) != 0 ? 0 : (flags & 2) != 0 ? 1 : 2;
        texture.world = (flags & WORLD) != 0;
        texture.negative = (flags & NEGATIVE) != 0;
    }

    private static void wrap(TextureBlock texture, ByteReader data) {
        texture.wrapU = wrap(data.u2());
        texture.wrapV = wrap(data.u2());
    }

    /** Wrap numbers of LWOB, other than those of LWO2: 0 none (black in LightWave), 1 edge, 2 repeat, 3 mirror. */
    private static Wrap wrap(int number) {
        return switch (number) {
            case 0 -> Wrap.NONE;
            case 1 -> Wrap.EDGE;
            case 3 -> Wrap.MIRROR;
            default -> Wrap.REPEAT;
        };
    }

    static double[] vector(ByteReader data) {
        return new double[] {data.f4(), data.f4(), data.f4()};
    }
}
