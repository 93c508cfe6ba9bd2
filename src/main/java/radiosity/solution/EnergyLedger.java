package radiosity.solution;

import radiosity.util.NoNumberException;

/**
 * Where the light went, one value per channel, in W (ACCURACY: emitted = absorbed + unshot + deficit).
 *
 * @param emitted  exitance times area over all elements
 * @param shot     flux that left shooters so far
 * @param received flux that arrived on elements
 * @param absorbed the part of it that was not reflected
 * @param unshot   flux gathered or emitted and not shot yet; signed
 */
public record EnergyLedger(double[] emitted, double[] shot, double[] received, double[] absorbed, double[] unshot) {

    /** Only numbers leave the solver. */
    public EnergyLedger {
        for (double[] flux : new double[][] {emitted, shot, received, absorbed, unshot}) {
            NoNumberException.unlessNumbers("ledger", flux);
        }
    }

    /** Shot but received nowhere: it escaped, fell on a back side, or is the form factors' fault. */
    public double deficit(int channel) {
        return shot[channel] - received[channel];
    }

    /** emitted - (absorbed + unshot + deficit), relative to what was emitted; 0 but for rounding. */
    public double imbalance(int channel) {
        double difference = emitted[channel] - absorbed[channel] - unshot[channel] - deficit(channel);
        double scale = Math.max(emitted[channel], shot[channel]);
        return scale == 0 ? 0 : difference / scale;
    }
}
