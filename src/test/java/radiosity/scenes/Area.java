package radiosity.scenes;

/** A rectangle in a plane with coordinates u and v. */
record Area(double u0, double v0, double u1, double v1) {

    static Area around(double u, double v, double halfWidth, double halfHeight) {
        return new Area(u - halfWidth, v - halfHeight, u + halfWidth, v + halfHeight);
    }

    boolean contains(double u, double v) {
        return u > u0 && u < u1 && v > v0 && v < v1;
    }
}
