package radiosity.protocol;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import radiosity.scene.Camera;
import radiosity.scene.Hierarchy;
import radiosity.scene.ImageBudget;
import radiosity.scene.ImageMap;
import radiosity.scene.Light;
import radiosity.scene.Luminaire;
import radiosity.scene.LuminousIntensity;
import radiosity.scene.Raster;
import radiosity.scene.Rgb;
import radiosity.scene.Scene;
import radiosity.scene.Surface;
import radiosity.scene.Vec3;
import radiosity.settings.FormFactors;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;

/**
 * Encodes the part of a scene that a host needs, and the settings: the original triangles, the object to which each
 * belongs, surfaces with their images as rasters of numbers, lights, and the camera, as a body around the camera keeps
 * its inner sides. Names stay with the master.
 */
public final class SceneBytes {

    /** Bytes of a surface without images, and of a light without luminaire. */
    private static final int SURFACE_BYTES = 51;
    private static final int LIGHT_BYTES = 146;

    private SceneBytes() { }

    /** A scene and the settings with which its light is calculated. */
    public record Task(Scene scene, RadiositySettings settings) { }

    /** @param whole a scene with any images; those of {@link ImageBudget} are written */
    public static byte[] write(Scene whole, RadiositySettings settings) {
        Scene scene = ImageBudget.forLight(whole);
        return Wire.bytes(out -> {
            write(out, settings);
            Wire.writeDoubles(out, scene.points());
            writeInts(out, scene.corners());
            writeInts(out, scene.surfaceOf());
            out.writeInt(scene.surfaces().size());
            for (Surface surface : scene.surfaces()) {
                write(out, surface.exitance());
                write(out, surface.reflectance());
                out.writeBoolean(surface.twoSided());
                write(out, surface.maps().exitance());
                write(out, surface.maps().reflectance());
            }
            writeFloats(out, scene.surfaces().stream().allMatch(surface -> surface.maps().isEmpty()) ? new float[0]
                    : scene.textureCoordinates());
            writeFloats(out, scene.vertexColours());
            writeInts(out, scene.hierarchy().nodeOf());
            out.writeInt(scene.lights().size());
            for (Light light : scene.lights()) {
                write(out, light);
            }
            out.writeBoolean(scene.camera().isPresent());
            if (scene.camera().isPresent()) {
                write(out, scene.camera().get());
            }
        });
    }

    /** @throws IOException where the bytes end early, or hold values that no scene or no settings have */
    public static Task read(DataInputStream in) throws IOException {
        try {
            return unchecked(in);
        } catch (IllegalArgumentException e) {
            throw new IOException(e.getMessage(), e);
        }
    }

    private static Task unchecked(DataInputStream in) throws IOException {
        RadiositySettings settings = new RadiositySettings(in.readDouble(), in.readInt(), in.readDouble(),
                constant(Schedule.values(), in.readByte()), in.readDouble(), in.readDouble(), in.readBoolean(),
                constant(FormFactors.values(), in.readByte()));
        double[] points = Wire.readDoubles(in);
        int[] corners = readInts(in);
        int[] surfaceOf = readInts(in);
        List<Surface> surfaces = new ArrayList<>();
        for (int n = Wire.count(in, SURFACE_BYTES), i = 0; i < n; i++) {
            surfaces.add(new Surface("surface " + i, rgb(in), rgb(in), in.readBoolean(), List.of(),
                    new Surface.Maps(raster(in), raster(in))));
        }
        float[] textureCoordinates = readFloats(in);
        float[] vertexColours = readFloats(in);
        int[] nodeOf = readInts(in);
        List<Light> lights = new ArrayList<>();
        for (int n = Wire.count(in, LIGHT_BYTES), i = 0; i < n; i++) {
            lights.add(new Light("light " + i, constant(Light.Kind.values(), in.readByte()), rgb(in), vec(in), vec(in),
                    vec(in), vec(in), in.readDouble(), in.readDouble(), in.readDouble(), luminaire(in)));
        }
        Optional<Camera> camera = in.readBoolean()
                ? Camera.of(vec(in), vec(in), vec(in), in.readDouble(), in.readDouble()) : Optional.empty();
        return new Task(new Scene("the master's scene", points, corners, surfaceOf, surfaces, lights,
                camera, textureCoordinates, vertexColours, Hierarchy.unnamed(nodeOf)), settings);
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
            write(out, v);
        }
        out.writeDouble(light.range());
        out.writeDouble(light.cone());
        out.writeDouble(light.edge());
        out.writeBoolean(light.luminaire().isPresent());
        if (light.luminaire().isPresent()) {
            write(out, light.luminaire().get());
        }
    }

    private static void write(DataOutputStream out, Camera camera) throws IOException {
        write(out, camera.position());
        write(out, camera.forward());
        write(out, camera.up());
        out.writeDouble(camera.verticalHalfAngle());
        out.writeDouble(camera.aspect());
    }

    private static void write(DataOutputStream out, Luminaire lamp) throws IOException {
        out.writeByte(lamp.intensity().type().ordinal());
        Wire.writeDoubles(out, lamp.intensity().horizontal());
        Wire.writeDoubles(out, lamp.intensity().vertical());
        Wire.writeDoubles(out, lamp.intensity().candela());
        write(out, lamp.zero());
        out.writeDouble(lamp.length());
        out.writeDouble(lamp.width());
    }

    private static Optional<Luminaire> luminaire(DataInputStream in) throws IOException {
        return !in.readBoolean() ? Optional.empty() : Optional.of(new Luminaire(new LuminousIntensity(
                constant(LuminousIntensity.Type.values(), in.readByte()), Wire.readDoubles(in), Wire.readDoubles(in),
                Wire.readDoubles(in)), vec(in), in.readDouble(), in.readDouble()));
    }

    private static void write(DataOutputStream out, Rgb value) throws IOException {
        for (int c = 0; c < 3; c++) {
            out.writeDouble(value.channel(c));
        }
    }

    private static void write(DataOutputStream out, Vec3 value) throws IOException {
        out.writeDouble(value.x());
        out.writeDouble(value.y());
        out.writeDouble(value.z());
    }

    private static void write(DataOutputStream out, Optional<Raster> raster) throws IOException {
        out.writeBoolean(raster.isPresent());
        if (raster.isPresent()) {
            Raster r = raster.get();
            out.writeInt(r.width());
            out.writeInt(r.height());
            writeFloats(out, r.rgb());
            out.writeByte(r.wrapU().ordinal());
            out.writeByte(r.wrapV().ordinal());
            write(out, r.outside());
        }
    }

    private static Optional<Raster> raster(DataInputStream in) throws IOException {
        return !in.readBoolean() ? Optional.empty() : Optional.of(new Raster(in.readInt(), in.readInt(), readFloats(in),
                constant(ImageMap.Wrap.values(), in.readByte()), constant(ImageMap.Wrap.values(), in.readByte()),
                rgb(in)));
    }

    private static void writeFloats(DataOutputStream out, float[] values) throws IOException {
        out.writeInt(values.length);
        for (float value : values) {
            out.writeFloat(value);
        }
    }

    private static float[] readFloats(DataInputStream in) throws IOException {
        float[] values = new float[Wire.count(in, Float.BYTES)];
        for (int i = 0; i < values.length; i++) {
            values[i] = in.readFloat();
        }
        return values;
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
