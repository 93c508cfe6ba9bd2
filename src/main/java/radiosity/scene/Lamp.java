package radiosity.scene;

/**
 * What gives light: a surface that emits, or a source without geometry.
 *
 * @param name    for the user
 * @param surface whether it is a surface
 * @param index   of the surface, or of the light, in its scene
 */
public record Lamp(String name, boolean surface, int index) {

    /** Whether this is the surface of that name. */
    public boolean isSurface(String of) {
        return surface && name.equals(of);
    }
}
