package radiosity.input.lightwave;

import static radiosity.input.lightwave.Iff.chunk;
import static radiosity.input.lightwave.Iff.f4;
import static radiosity.input.lightwave.Iff.f8;
import static radiosity.input.lightwave.Iff.form;
import static radiosity.input.lightwave.Iff.join;
import static radiosity.input.lightwave.Iff.s0;
import static radiosity.input.lightwave.Iff.sub;
import static radiosity.input.lightwave.Iff.text;
import static radiosity.input.lightwave.Iff.u2;
import static radiosity.input.lightwave.Iff.u4;

/** Small files that use most of what the formats have. */
final class SoundFiles {

    private SoundFiles() {
    }

    /** A square with an image by texture coordinates, one of its corners overridden. */
    static byte[] texturedLwo2() {
        return Objects.lwo2(
                chunk("VMAP", text("TXUV"), u2(2), s0("map"), u2(0), f4(0, 0), u2(1), f4(0, 1), u2(2), f4(1, 1), u2(3),
                        f4(1, 0)),
                chunk("VMAD", text("TXUV"), u2(2), s0("map"), u2(2, 0), f4(0.5, 0.25)),
                chunk("CLIP", u4(1), sub("STIL", s0("wood.png"))),
                Objects.lwo2Surface("white", "", Objects.colour(0.5, 0.5, 0.5), Objects.share("DIFF", 0.8),
                        imageBlock("COLR", 5, sub("VMAP", s0("map")))));
    }

    /** A texture block with an image, projected somehow. */
    static byte[] imageBlock(String channel, int projection, byte[]... more) {
        return sub("BLOK", sub("IMAP", s0("a"), sub("CHAN", text(channel)), sub("OPAC", u2(0), f4(1), u2(0)),
                sub("ENAB", u2(1))), sub("PROJ", u2(projection)), sub("IMAG", u2(1)), sub("WRAP", u2(1, 1)),
                        join(more));
    }

    /** A square whose material stands in nodes. */
    static byte[] lwo3() {
        return form("LWO3", chunk("TAGS", s0("white")), Objects.layer(0, 0), Objects.squareOf("FACE"),
                nodeSurface("white", "Principled BSDF", attribute("Color", 0.25, 0.5, 0.75), attribute("Luminous", 2),
                        attribute("Luminous Color", 1, 0.5, 0)));
    }

    static byte[] nodeSurface(String name, String server, byte[]... attributes) {
        return form("SURF", chunk("    ", s0(name)), form("NODS", form("NNDS", node("Surface", "Surface"),
                node(server, "m", attributes)), form("NCON", link("Surface", "Material", "m"))));
    }

    static byte[] node(String server, String name, byte[]... attributes) {
        return join(chunk("NSRV", s0(server)), form("NTAG", chunk("NNME", s0(name)),
                form("NDTA", form("ATTR", form("META", form("ADAT", attributes))))));
    }

    static byte[] link(String node, String input, String source) {
        return join(chunk("INME", s0(node)), chunk("IINM", s0(input)), chunk("IINN", s0(source)),
                chunk("IONM", s0("Material")));
    }

    static byte[] attribute(String name, double... values) {
        return form("ENTR", chunk("NAME", s0(name)), form("VALU", chunk("    ", s0("vparam")),
                form("VALU", chunk("    ", u4(values.length), f8(values)))));
    }

    static String scene1() {
        return """
                LWSC
                1

                FirstFrame 1
                FramesPerSecond 25

                LoadObject room.lwo
                ObjectMotion (unnamed)
                  9
                  2
                  0 0 0 10 20 30 1 1 1
                  0 0 0 0 0
                  1 2 3 40 50 60 2 2 2
                  30 1 0.5 0 0
                EndBehavior 2
                PivotPoint 1 0 0
                ObjDissolve (envelope)
                  1
                  1
                  0.25
                  0 0 0 0 0
                EndBehavior 1
                AddNullObject centre
                ParentObject 1

                AddLight
                LightName Sun
                LightMotion (unnamed)
                  9
                  1
                  0 5 0 0 90 0 1 1 1
                  0 0 0 0 0
                EndBehavior 1
                LightColor 255 128 0
                LgtIntensity 0.5
                LightType 2
                ConeAngle 30
                EdgeAngle 5

                CameraMotion (unnamed)
                  9
                  1
                  0 1 -5 0 0 0 1 1 1
                  0 0 0 0 0
                EndBehavior 1
                TargetObject 2
                ZoomFactor 3.2
                """;
    }

    static String scene5() {
        return """
                LWSC
                5

                FirstFrame 0
                FramesPerSecond 30
                LoadObjectLayer 1 10000000 room.lwo
                ObjectMotion
                NumChannels 9
                Channel 0
                { Envelope
                  2
                  Key 0 0 0 0 0 0 0 0 0
                  Key 1 1 5 -0.2 0.1 0.4 -0.1 0 0
                  Behaviors 1 2
                }
                Channel 6
                { Envelope
                  1
                  Key 1 0 0 0 0 0
                  Behaviors 1 1
                }
                PivotPosition 0.5 0.5 0
                PivotRotation 10 0 0
                Plugin ObjectHandler 1 Thing
                { some
                text }
                EndPlugin
                AddNullObject 10000001 centre
                ParentItem 10000000
                AddLight 20000000
                LightName Lamp
                LightColor 1 1 1
                LightIntensity (envelope)
                { Envelope
                  1
                  Key 0.5 0 0 0 0 0
                  Behaviors 1 1
                }
                LightType 4
                Plugin LightHandler 1 AreaLight
                EndPlugin
                AddCamera 30000000
                ZoomFactor 2.4
                FrameSize 640 480
                TargetItem 10000001
                """;
    }
}
