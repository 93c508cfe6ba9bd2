package radiosity.input.lightwave.lws;

import radiosity.scene.Affine;

/** Turns lights and cameras towards their targets: the target determines heading and pitch, bank is kept. */
final class LookAt {

    private final Placement placement;
    private final Motion.Instant instant;

    LookAt(Placement placement, Motion.Instant instant) {
        this.placement = placement;
        this.instant = instant;
    }

    /** From the item's own space to the scene's, turned towards the item's target if it has one. */
    Affine world(SceneItem item) {
        SceneItem target = placement.target(item);
        if (target == null || target == item) {
            return placement.world(item);
        }
        double[] at = placement.position(target);
        double[] from = placement.position(item);
        Affine parent = placement.parentWorld(item);
        double[] d = parent.unturn(new double[] {at[0] - from[0], at[1] - from[1], at[2] - from[2]});
        double flat = StrictMath.hypot(d[0], d[2]);
        if (!(flat + Math.abs(d[1]) > 0) || !Double.isFinite(flat + d[1])) {
            return placement.world(item);
        }
        Affine turned = parent.times(Turn.of(StrictMath.atan2(d[0], d[2]), -StrictMath.atan2(d[1], flat),
                item.motion.bank(instant))).times(item.motion.scale(instant));
        double[] m = turned.m().clone();
        m[3] = from[0];
        m[7] = from[1];
        m[11] = from[2];
        return new Affine(m);
    }
}
