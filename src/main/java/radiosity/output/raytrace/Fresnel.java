package radiosity.output.raytrace;

import radiosity.scene.Specular;
import radiosity.scene.Vec3;

/**
 * Reflection and refraction of unpolarised light where the refractive index changes (W. Snell, 1621; A. Fresnel, 1823).
 *
 * <p>An index is here the refractive index of the side to which a ray goes over that of the side from which it comes.
 */
final class Fresnel {

    private Fresnel() { }

    /**
     * F: reflected over arriving light; 1 at total reflection.
     *
     * @param cosine of the angle between the ray and the normal, from 0 to 1
     */
    static double reflectance(double cosine, double index) {
        double beyond = 1 - (1 - cosine * cosine) / (index * index);
        if (beyond <= 0 || cosine <= 0) {
            return 1;
        }
        double refracted = Math.sqrt(beyond);
        double across = (cosine - index * refracted) / (cosine + index * refracted);
        double along = (index * cosine - refracted) / (index * cosine + refracted);
        return (across * across + along * along) / 2;
    }

    /** f = (F - F0) / (1 - F0): 0 at right angles, 1 where the surface reflects all light; 0 for an index of 1. */
    static double rise(double cosine, double index) {
        if (index == 1) {
            return 0;
        }
        double normal = Specular.normalReflectance(index);
        return (reflectance(cosine, index) - normal) / (1 - normal);
    }

    /**
     * The direction of a refracted ray, or null at total reflection.
     *
     * @param direction unit direction of the ray
     * @param normal    unit normal on the side from which the ray comes
     */
    static Vec3 refracted(Vec3 direction, Vec3 normal, double index) {
        double cosine = -direction.dot(normal);
        double beyond = 1 - (1 - cosine * cosine) / (index * index);
        return beyond <= 0 ? null
                : direction.times(1 / index).plus(normal.times(cosine / index - Math.sqrt(beyond))).unit();
    }

    static Vec3 mirrored(Vec3 direction, Vec3 normal) {
        return direction.minus(normal.times(2 * direction.dot(normal))).unit();
    }
}
