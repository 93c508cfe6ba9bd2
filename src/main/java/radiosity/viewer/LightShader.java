package radiosity.viewer;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.jogamp.java3d.Appearance;
import org.jogamp.java3d.GLSLShaderProgram;
import org.jogamp.java3d.PolygonAttributes;
import org.jogamp.java3d.Shader;
import org.jogamp.java3d.ShaderAppearance;
import org.jogamp.java3d.ShaderAttributeObject;
import org.jogamp.java3d.ShaderAttributeSet;
import org.jogamp.java3d.ShaderAttributeValue;
import org.jogamp.java3d.SourceCodeShader;
import org.jogamp.java3d.Texture;
import radiosity.output.image.ToneMapping;

/** The shaders that map radiosity to colours on the screen. Changing exposure or curve only sets shader variables. */
final class LightShader {

    private static final String VERSION = "#version 120\n";

    private final ShaderAttributeObject exposure = attribute("exposure", 1f);
    private final ShaderAttributeObject curve = attribute("curve", 0);
    private final ShaderAttributeObject falseColour = attribute("falseColour", 0);
    private final ShaderAttributeObject bakedExposure = attribute("bakedExposure", 1f);
    private final ShaderAttributeObject bakedCurve = attribute("bakedCurve", 0);
    private final ShaderAttributeObject image = attribute("image", 0);
    private final PolygonAttributes polygons = new PolygonAttributes();
    private final GLSLShaderProgram textureProgram;
    private final ShaderAttributeSet textureAttributes;
    private final Appearance vertices;

    LightShader() {
        polygons.setCapability(PolygonAttributes.ALLOW_MODE_WRITE);
        List<ShaderAttributeObject> light = List.of(exposure, curve, falseColour);
        List<ShaderAttributeObject> texture = List.of(exposure, curve, falseColour, bakedExposure, bakedCurve, image);
        vertices = appearance(program("light.vert", VERSION, light), attributes(light));
        textureProgram = program("texture.vert", VERSION + "#define TEXTURES\n", texture);
        textureAttributes = attributes(texture);
    }

    private static ShaderAttributeObject attribute(String name, Object value) {
        ShaderAttributeValue attribute = new ShaderAttributeValue(name, value);
        attribute.setCapability(ShaderAttributeObject.ALLOW_VALUE_WRITE);
        return attribute;
    }

    /** @param head text that replaces the version line of the fragment shader */
    private static GLSLShaderProgram program(String vertex, String head, List<ShaderAttributeObject> attributes) {
        GLSLShaderProgram program = new GLSLShaderProgram();
        program.setShaders(new Shader[] {shader(Shader.SHADER_TYPE_VERTEX, source(vertex)),
            shader(Shader.SHADER_TYPE_FRAGMENT, source("light.frag").replace(VERSION, head))});
        program.setShaderAttrNames(attributes.stream().map(ShaderAttributeObject::getAttributeName)
                .toArray(String[]::new));
        return program;
    }

    private static ShaderAttributeSet attributes(List<ShaderAttributeObject> attributes) {
        ShaderAttributeSet set = new ShaderAttributeSet();
        attributes.forEach(set::put);
        return set;
    }

    private ShaderAppearance appearance(GLSLShaderProgram program, ShaderAttributeSet attributes) {
        ShaderAppearance appearance = new ShaderAppearance();
        appearance.setShaderProgram(program);
        appearance.setShaderAttributeSet(attributes);
        appearance.setPolygonAttributes(polygons);
        return appearance;
    }

    private static Shader shader(int type, String source) {
        return new SourceCodeShader(Shader.SHADING_LANGUAGE_GLSL, type, source);
    }

    private static String source(String name) {
        try (InputStream in = LightShader.class.getResourceAsStream(name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new IllegalStateException("the jar has every shader", e);
        }
    }

    /** Appearance of surfaces whose radiosity is at their vertices. */
    Appearance vertices() {
        return vertices;
    }

    /** Appearance of a surface whose light is in a texture. */
    Appearance textured(Texture texture) {
        ShaderAppearance appearance = appearance(textureProgram, textureAttributes);
        appearance.setTexture(texture);
        return appearance;
    }

    /** @param toneMapping tone mapping by which radiosity was stored in the textures */
    void baked(ToneMapping toneMapping) {
        bakedExposure.setValue((float) toneMapping.exposure());
        bakedCurve.setValue(toneMapping.operator().ordinal());
    }

    void toneMapping(ToneMapping toneMapping) {
        exposure.setValue((float) toneMapping.exposure());
        curve.setValue(toneMapping.operator().ordinal());
    }

    void falseColour(boolean on) {
        falseColour.setValue(on ? 1 : 0);
    }

    void wireframe(boolean on) {
        polygons.setPolygonMode(on ? PolygonAttributes.POLYGON_LINE : PolygonAttributes.POLYGON_FILL);
    }
}
