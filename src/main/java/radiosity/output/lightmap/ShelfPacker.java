package radiosity.output.lightmap;

import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/** Packs charts into one texture: side by side on shelves from the top down, the highest charts first. */
final class ShelfPacker {

    /** Size of the texture, texels. */
    final int width;
    final int height;
    /** Upper left corner of each chart in the order of the charts, texels. */
    final int[] x;
    final int[] y;

    ShelfPacker(List<Chart> charts) {
        x = new int[charts.size()];
        y = new int[charts.size()];
        double area = charts.stream().mapToDouble(c -> (double) c.width() * c.height()).sum();
        int widest = charts.stream().mapToInt(Chart::width).max().orElse(1);
        width = Math.max(widest, (int) Math.ceil(Math.sqrt(area)));
        int right = 0;
        int top = 0;
        int shelf = 0;
        for (int c : IntStream.range(0, charts.size()).boxed()
                .sorted(Comparator.comparing(c -> -charts.get(c).height())).toList()) {
            if (right + charts.get(c).width() > width) {
                top += shelf;
                right = 0;
                shelf = 0;
            }
            x[c] = right;
            y[c] = top;
            right += charts.get(c).width();
            shelf = Math.max(shelf, charts.get(c).height());
        }
        height = top + shelf;
    }
}
