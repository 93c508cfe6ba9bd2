package radiosity.mesh.face;

import java.util.BitSet;
import java.util.List;
import java.util.function.IntFunction;
import radiosity.scene.Scene;
import radiosity.scene.Vec3;
import radiosity.util.ArraySize;
import radiosity.util.PointNumbers;

/** Arrays of faces that are added one by one: the radiating sides of a scene's triangles, or pieces of cut ones. */
final class FaceList {

    private final SceneBox box;
    /** Corners of faces: points of the scene and points that cutting made. */
    final CutPoints points;
    int count;
    /** Number of triangles that were too small to radiate. */
    int dropped;
    /** 1 per face: 2 * original triangle, + 1 for the back. */
    final int[] side;
    /** 9 per face: three corners, counter-clockwise seen from the side that radiates. */
    final float[] corner;
    /** 3 per face, length 1. */
    final float[] normal;
    /** 1 per face, in squared scene sizes. */
    final double[] area;
    /** Area of all faces, in squared scene sizes. */
    double wholeArea;
    /** 3 per face: number of the point at each corner; equal coordinates have equal numbers. */
    final int[] point;
    /** 1 per face: whether it is a piece of a triangle that was cut. */
    final boolean[] piece;

    /** @param most largest number of faces */
    private FaceList(SceneBox box, CutPoints points, int most) {
        this.box = box;
        this.points = points;
        side = new int[most];
        corner = new float[ArraySize.of("corners of the sides of triangles", 9, most)];
        normal = new float[3 * most];
        area = new double[most];
        point = new int[3 * most];
        piece = new boolean[most];
    }

    /** The sides of a scene's triangles that radiate. */
    static FaceList of(Scene scene, SceneBox box) {
        int most = 0;
        for (int t = 0; t < scene.triangles(); t++) {
            most += scene.surface(t).twoSided() ? 2 : 1;
        }
        FaceList list = new FaceList(box, new CutPoints(scene, 0), most);
        int[] numbers = PointNumbers.of(scene.points());
        for (int t = 0; t < scene.triangles(); t++) {
            list.add(scene, t, numbers);
        }
        return list;
    }

    /** The same faces, with pieces in the place of those that are cut. */
    FaceList withPieces(FacePieces cut) {
        return replaced(cut.points(), count + cut.count(), f -> cut.byFace().get(f));
    }

    /** The same faces without some of them. */
    FaceList without(BitSet some) {
        return replaced(points, count, f -> some.get(f) ? List.of() : null);
    }

    /** @param pieces what takes the place of a face; null where the face stays */
    private FaceList replaced(CutPoints all, int most, IntFunction<List<int[]>> pieces) {
        FaceList list = new FaceList(box, all, most);
        list.dropped = dropped;
        for (int f = 0; f < count; f++) {
            List<int[]> its = pieces.apply(f);
            if (its == null) {
                list.add(this, f, piece[f], point[3 * f], point[3 * f + 1], point[3 * f + 2]);
            } else {
                for (int[] p : its) {
                    list.add(this, f, true, p[0], p[1], p[2]);
                }
            }
        }
        return list;
    }

    private void add(FaceList whole, int face, boolean isPiece, int p, int q, int r) {
        Vec3 a = box.unit(points.at(p));
        Vec3 b = box.unit(points.at(q));
        Vec3 c = box.unit(points.at(r));
        double itsArea = b.minus(a).cross(c.minus(a)).length() / 2;
        if (itsArea < Faces.LEAST_AREA) {
            return;
        }
        piece[count] = isPiece;
        Vec3 n = new Vec3(whole.normal[3 * face], whole.normal[3 * face + 1], whole.normal[3 * face + 2]);
        add(whole.side[face], a, b, c, n, itsArea, p, q, r);
    }

    private void add(Scene scene, int triangle, int[] numbers) {
        Vec3 a = box.unit(scene.corner(triangle, 0));
        Vec3 b = box.unit(scene.corner(triangle, 1));
        Vec3 c = box.unit(scene.corner(triangle, 2));
        Vec3 cross = b.minus(a).cross(c.minus(a));
        double twice = cross.length();
        if (twice < 2 * Faces.LEAST_AREA) {
            dropped++;
            return;
        }
        int p = numbers[scene.corners()[3 * triangle]];
        int q = numbers[scene.corners()[3 * triangle + 1]];
        int r = numbers[scene.corners()[3 * triangle + 2]];
        Vec3 n = cross.times(1 / twice);
        add(2 * triangle, a, b, c, n, twice / 2, p, q, r);
        if (scene.surface(triangle).twoSided()) {
            add(2 * triangle + 1, a, c, b, n.times(-1), twice / 2, p, r, q);
        }
    }

    private void add(int id, Vec3 a, Vec3 b, Vec3 c, Vec3 n, double faceArea, int p, int q, int r) {
        side[count] = id;
        area[count] = faceArea;
        wholeArea += faceArea;
        a.write(corner, 9 * count);
        b.write(corner, 9 * count + 3);
        c.write(corner, 9 * count + 6);
        n.write(normal, 3 * count);
        point[3 * count] = p;
        point[3 * count + 1] = q;
        point[3 * count + 2] = r;
        count++;
    }
}
