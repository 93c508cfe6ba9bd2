package radiosity.world;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import radiosity.formfactor.FormFactors;
import radiosity.scene.Light;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;

/**
 * What a host must know of a scene, and the settings, as bytes: original triangles, surfaces and lights. Names, images
 * and the camera stay with the master.
 */
final class SceneBytes {

    private static final int SURFACE_BYTES = 49;
    private static final int LIGHT_BYTES = 145;

    private SceneBytes() { }

    /** A scene and how to compute it. */
    record Task(Scene scene, RadiositySettings settings) { }

    static byte[] write(Scene scene, RadiositySettings settings) {
        return Wire.bytes(out -> {
            write(out, settings);
            out.writeInt(scene.points().length);
            for (double x : scene.points()) {
                out.writeDouble(x);
            }
            writeInts(out, scene.corners());
            writeInts(out, scene.surfaceOf());
            out.writeInt(scene.surfaces().size());
            for (Surface surface : scene.surfaces()) {
                write(out, surface.exitance());
                write(out, surface.reflectance());
                out.writeBoolean(surface.twoSided());
            }
            out.writeInt(scene.lights().size());
            for (Light light : scene.lights()) {
                write(out, light);
            }
        });
    }

    static Task read(byte[] bytes) throws IOException {
        DataInputStream in = Wire.input(bytes);
        RadiositySettings settings = new RadiositySettings(in.readDouble(), in.readInt(), in.readDouble(),
                constant(Schedule.values(), in.readByte()), in.readDouble(), in.readDouble(), in.readBoolean(),
                constant(FormFactors.values(), in.readByte()));
        double[] points = new double[Wire.count(in, Double.BYTES)];
        for (int i = 0; i < points.length; i++) {
            points[i] = in.readDouble();
        }
        int[] corners = readInts(in);
        int[] surfaceOf = readInts(in);
        List<Surface> surfaces = new ArrayList<>();
        for (int n = Wire.count(in, SURFACE_BYTES), i = 0; i < n; i++) {
            surfaces.add(new Surface("surface " + i, rgb(in), rgb(in), in.readBoolean()));
        }
        List<Light> lights = new ArrayList<>();
        for (int n = Wire.count(in, LIGHT_BYTES), i = 0; i < n; i++) {
            lights.add(new Light("light " + i, constant(Light.Kind.values(), in.readByte()), rgb(in), vec(in), vec(in),
                    vec(in), vec(in), in.readDouble(), in.readDouble(), in.readDouble()));
        }
        return new Task(new Scene("the master's scene", points, corners, surfaceOf, surfaces, lights,
                Optional.empty()), settings);
    }

    private static void write(DataOutputStream out, RadiositySettings settings) throws IOException {
        out.writeDouble(settings.patchArea());
        out.writeInt(settings.rays());
        out.writeDouble(settings.meshing());
        out.writeByte(settings.schedule().ordinal());
        out.writeDouble(settings.tolerance());
        out.writeDouble(settings.meshError());
        out.writeBoolean(settings.layers());
        out.writeByte(settings.factors().ordinal());
    }

    private static void write(DataOutputStream out, Light light) throws IOException {
        out.writeByte(light.kind().ordinal());
        write(out, light.power());
        for (Vec3 v : List.of(light.position(), light.direction(), light.right(), light.up())) {
            out.writeDouble(v.x());
            out.writeDouble(v.y());
            out.writeDouble(v.z());
        }
        out.writeDouble(light.range());
        out.writeDouble(light.cone());
        out.writeDouble(light.edge());
    }

    private static void write(DataOutputStream out, Rgb value) throws IOException {
        for (int c = 0; c < 3; c++) {
            out.writeDouble(value.channel(c));
        }
    }

    private static void writeInts(DataOutputStream out, int[] values) throws IOException {
        out.writeInt(values.length);
        for (int value : values) {
            out.writeInt(value);
        }
    }

    private static int[] readInts(DataInputStream in) throws IOException {
        int[] values = new int[Wire.count(in, Integer.BYTES)];
        for (int i = 0; i < values.length; i++) {
            values[i] = in.readInt();
        }
        return values;
    }

    private static Rgb rgb(DataInputStream in) throws IOException {
        return new Rgb(in.readDouble(), in.readDouble(), in.readDouble());
    }

    private static Vec3 vec(DataInputStream in) throws IOException {
        return new Vec3(in.readDouble(), in.readDouble(), in.readDouble());
    }

    private static <E> E constant(E[] all, int number) throws IOException {
        if (number < 0 || number >= all.length) {
            throw new IOException("scene: expected a constant below " + all.length + ", got " + number);
        }
        return all[number];
    }
}
