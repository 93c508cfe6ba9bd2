package radiosity.input.lightwave.lws;

import radiosity.scene.Affine;

/** Rotations in LightWave's left-handed space: Ry(h) takes +z to +x, Rx(p) takes +z to -y, Rz(b) takes +x to +y. */
public final class Turn {

    private Turn() {
    }

    /** Ry(heading) Rx(pitch) Rz(bank), radians. */
    public static Affine of(double heading, double pitch, double bank) {
        double ch = StrictMath.cos(heading);
        double sh = StrictMath.sin(heading);
        double cp = StrictMath.cos(pitch);
        double sp = StrictMath.sin(pitch);
        double cb = StrictMath.cos(bank);
        double sb = StrictMath.sin(bank);
        return new Affine(new double[] {
            ch * cb + sh * sp * sb, -ch * sb + sh * sp * cb, sh * cp, 0,
            cp * sb, cp * cb, -sp, 0,
            -sh * cb + ch * sp * sb, sh * sb + ch * sp * cb, ch * cp, 0});
    }
}
