package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import radiosity.input.lightwave.LightWaveReader;
import radiosity.scene.Scene;
import radiosity.settings.ReadOptions;
import radiosity.solution.Solution;
import radiosity.testkit.SharedData;
import radiosity.testkit.Solve;

/** The same calculation gives the same bits: sample points belong to receiver and shooter, and sums have no order. */
@Tag("slow")
class DeterminismTest {

    @Test
    void oneThreadAndTwo_giveTheSameBits() throws IOException {
        Scene scene = LightWaveReader.read(SharedData.truth("lightwave", "cornell_blocks.lws"),
                ReadOptions.defaults(), warning -> { });
        Solve solve = Solve.byDefault().patches(scene, 600).unsent(0.02);
        Solution one = solve.threads(1).solution(scene);
        Solution two = solve.threads(2).solution(scene);
        assertArrayEquals(one.irradiance(), two.irradiance());
        assertArrayEquals(one.positions(), two.positions());
        assertArrayEquals(one.corners(), two.corners());
        assertEquals(one.state(), two.state());
        assertArrayEquals(one.ledger().received(), two.ledger().received());
    }
}
