package radiosity.scene;

/**
 * A source of light of a scene: a surface that emits, or a light without geometry.
 *
 * @param name    name shown to the user
 * @param surface whether the lamp is a surface
 * @param index   index of the surface in {@link Scene#surfaces()}, or of the light in {@link Scene#lights()}
 */
public record Lamp(String name, boolean surface, int index) {

    /** Whether this lamp is the surface with the given name. */
    public boolean isSurface(String of) {
        return surface && name.equals(of);
    }
}
