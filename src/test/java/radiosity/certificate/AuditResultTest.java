package radiosity.certificate;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class AuditResultTest {

    @Test
    void outlier_countsAsTheSecondLargest() {
        double[] shares = new double[200];
        Arrays.fill(shares, 1);
        shares[17] = 2;
        shares[150] = 1000;
        AuditResult.winsorize(shares);
        assertEquals(2, shares[150]);
        assertEquals(202, Arrays.stream(shares).sum());
        AuditResult.winsorize(shares);
        assertEquals(202, Arrays.stream(shares).sum(), "two that are equal stay");
    }

    @Test
    void ofFew_noneIsAnOutlier() {
        double[] shares = {1, 1, 1000};
        AuditResult.winsorize(shares);
        assertEquals(1000, shares[2]);
    }
}
