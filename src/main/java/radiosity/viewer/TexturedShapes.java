package radiosity.viewer;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import javax.imageio.ImageIO;
import org.jogamp.java3d.BoundingSphere;
import org.jogamp.java3d.BranchGroup;
import org.jogamp.java3d.GeometryArray;
import org.jogamp.java3d.ImageComponent;
import org.jogamp.java3d.ImageComponent2D;
import org.jogamp.java3d.Shape3D;
import org.jogamp.java3d.Texture;
import org.jogamp.java3d.Texture2D;
import org.jogamp.java3d.TriangleArray;
import radiosity.output.gltf.LitScene;
import radiosity.output.gltf.TexturedMesh;

/** Makes Java 3D shapes of the original triangles with their light in textures (section 4.6 of the paper). */
final class TexturedShapes {

    private TexturedShapes() { }

    /** @throws IOException where a texture is not a PNG picture */
    static BranchGroup of(LitScene.Textures textures, LightShader shader, BoundingSphere bounds) throws IOException {
        BranchGroup group = new BranchGroup();
        group.setCapability(BranchGroup.ALLOW_DETACH);
        for (TexturedMesh mesh : textures.meshes()) {
            group.addChild(SceneShapes.shape(triangles(mesh), shader.textured(texture(mesh)), bounds));
        }
        shader.baked(textures.toneMapping());
        return group;
    }

    private static GeometryArray triangles(TexturedMesh mesh) {
        int count = mesh.positions().length / 3;
        TriangleArray triangles = new TriangleArray(count,
                GeometryArray.COORDINATES | GeometryArray.TEXTURE_COORDINATE_2);
        triangles.setCoordinates(0, mesh.positions());
        float[] upwards = mesh.places().clone();
        for (int i = 1; i < upwards.length; i += 2) {
            upwards[i] = 1 - upwards[i];
        }
        triangles.setTextureCoordinates(0, 0, upwards);
        return triangles;
    }

    private static Texture texture(TexturedMesh mesh) throws IOException {
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(mesh.png()));
        if (image == null) {
            throw new IOException("scene file: expected PNG pictures as textures, got something else");
        }
        Texture texture = new Texture2D(Texture.BASE_LEVEL, Texture.RGB, image.getWidth(), image.getHeight());
        texture.setImage(0, new ImageComponent2D(ImageComponent.FORMAT_RGB, image));
        texture.setMagFilter(Texture.BASE_LEVEL_LINEAR);
        texture.setMinFilter(Texture.BASE_LEVEL_LINEAR);
        texture.setBoundaryModeS(Texture.CLAMP_TO_EDGE);
        texture.setBoundaryModeT(Texture.CLAMP_TO_EDGE);
        return texture;
    }
}
