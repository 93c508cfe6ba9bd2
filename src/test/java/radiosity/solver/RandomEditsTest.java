package radiosity.solver;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.edit.LightDifference;
import radiosity.scene.Scene;
import radiosity.solution.EnergyLedger;
import radiosity.solution.Solution;
import radiosity.testkit.Changing;
import radiosity.testkit.RandomEdits;

/** Errors and energy of edits one after another do not add up; scripts/change edits prints the same at 2 %. */
@Tag("slow")
class RandomEditsTest {

    private static final int EDITS = 50;
    private static final Changing COARSE = new Changing(0.05);
    private static final Changing FINE = new Changing(0.01);
    /** Largest part of the emitted flux that edits may gain. */
    private static final double GAINED = 0.002;

    /** The error is that of a render anew, times 1.2 at most; the error of the reference counts in both. */
    @Test
    void fiftyEdits_areAsExactAsARenderAnewAndGainNothing() throws IOException {
        Solution now = COARSE.anew(RandomEdits.room(0));
        for (int n = 1; n <= EDITS; n++) {
            now = COARSE.changed(RandomEdits.room(n), now.state());
            EnergyLedger ledger = now.ledger();
            for (int c = 0; c < ledger.emitted().length; c++) {
                assertEquals(0, ledger.imbalance(c), 1e-12, "after edit " + n);
                assertTrue(-ledger.deficit(c) <= GAINED * ledger.emitted()[c], "gains after edit " + n);
            }
        }
        Scene scene = RandomEdits.room(EDITS);
        double[] places = LightDifference.places(scene, 4000);
        double[] truth = LightDifference.radiosity(FINE.anew(scene), places);
        double error = LightDifference.of(truth, LightDifference.radiosity(now, places));
        double anew = LightDifference.of(truth, LightDifference.radiosity(COARSE.anew(scene), places));
        assertTrue(error <= 1.2 * anew, "error " + error + ", rendered anew " + anew);
    }
}
