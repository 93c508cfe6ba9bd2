package radiosity.certificate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class AuditResultTest {

    @Test
    void largestErrors_areLeftOutOverHalfAThousandthOfTheArea() {
        double[] values = {1, 7, 3, 9};
        double[] areas = {1999, .4, .3, .3};
        double[] before = areas.clone();
        double[] left = AuditResult.trimmed(values, areas);
        assertArrayEquals(new double[] {1999, 0, 0, 0}, left, 1e-9);
        assertArrayEquals(before, areas, "areas are not modified");
    }

    @Test
    void ofOneLargePoint_onlyThatPartIsLeftOut() {
        double[] areas = new double[200];
        Arrays.fill(areas, 1);
        double[] values = new double[200];
        values[17] = 1000;
        double[] left = AuditResult.trimmed(values, areas);
        assertEquals(.9, left[17], 1e-12);
        assertEquals(199.9, Arrays.stream(left).sum(), 1e-9);
    }

    /** A point of which one of two estimates holds the error of a bright place near by, and the other does not. */
    @Test
    void oneNoisyPoint_doesNotOutweighTheErrorsOfAllOthers() {
        double[] areas = new double[3000];
        Arrays.fill(areas, 1);
        double[] products = new double[3000];
        Arrays.fill(products, .0013);
        products[1234] = -13;
        assertEquals(.0013, AuditResult.Trimmed.of(areas, products).mean(), 1e-12);
        products[1234] = 13;
        assertEquals(.0013, AuditResult.Trimmed.of(areas, products).mean(), 1e-12);
    }
}
