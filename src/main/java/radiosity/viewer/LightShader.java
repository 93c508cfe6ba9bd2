package radiosity.viewer;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import org.jogamp.java3d.Appearance;
import org.jogamp.java3d.GLSLShaderProgram;
import org.jogamp.java3d.PolygonAttributes;
import org.jogamp.java3d.Shader;
import org.jogamp.java3d.ShaderAppearance;
import org.jogamp.java3d.ShaderAttributeObject;
import org.jogamp.java3d.ShaderAttributeSet;
import org.jogamp.java3d.ShaderAttributeValue;
import org.jogamp.java3d.SourceCodeShader;
import radiosity.output.ToneMapping;

/** How the light of the vertices becomes colour on the screen: exposure and curve are numbers that cost nothing. */
final class LightShader {

    private static final String EXPOSURE = "exposure";
    private static final String CURVE = "curve";
    private static final String FALSE_COLOUR = "falseColour";

    private final ShaderAttributeObject exposure = attribute(EXPOSURE, 1f);
    private final ShaderAttributeObject curve = attribute(CURVE, 0);
    private final ShaderAttributeObject falseColour = attribute(FALSE_COLOUR, 0);
    private final PolygonAttributes polygons = new PolygonAttributes();
    private final ShaderAppearance appearance = new ShaderAppearance();

    LightShader() {
        polygons.setCapability(PolygonAttributes.ALLOW_MODE_WRITE);
        GLSLShaderProgram program = new GLSLShaderProgram();
        program.setShaders(new Shader[] {shader(Shader.SHADER_TYPE_VERTEX, "light.vert"),
            shader(Shader.SHADER_TYPE_FRAGMENT, "light.frag")});
        program.setShaderAttrNames(new String[] {EXPOSURE, CURVE, FALSE_COLOUR});
        ShaderAttributeSet attributes = new ShaderAttributeSet();
        attributes.put(exposure);
        attributes.put(curve);
        attributes.put(falseColour);
        appearance.setShaderProgram(program);
        appearance.setShaderAttributeSet(attributes);
        appearance.setPolygonAttributes(polygons);
    }

    private static ShaderAttributeObject attribute(String name, Object value) {
        ShaderAttributeValue attribute = new ShaderAttributeValue(name, value);
        attribute.setCapability(ShaderAttributeObject.ALLOW_VALUE_WRITE);
        return attribute;
    }

    private static Shader shader(int type, String name) {
        try (InputStream in = LightShader.class.getResourceAsStream(name)) {
            return new SourceCodeShader(Shader.SHADING_LANGUAGE_GLSL, type,
                    new String(in.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new IllegalStateException("the jar has every shader", e);
        }
    }

    /** For every surface of the scene. */
    Appearance appearance() {
        return appearance;
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
