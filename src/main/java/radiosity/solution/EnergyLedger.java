package radiosity.solution;

import radiosity.util.NoNumberException;

/**
 * Balance of the light, one number per channel, W: emitted = absorbed + unshot + deficit (see docs/CERTIFICATE.md).
 *
 * @param emitted  flux that elements emit, exitance times area, and flux that arrives from lights without geometry
 * @param shot     flux that shooters have shot
 * @param received flux that has arrived on elements
 * @param absorbed part of the received flux that was not reflected
 * @param unshot   flux emitted or reflected and not shot yet; signed
 * @param escaped  part of the shot flux that left the scene or fell on an invisible side, as rays have found; empty
 *                 where no rays looked for it
 */
public record EnergyLedger(double[] emitted, double[] shot, double[] received, double[] absorbed, double[] unshot,
                           double[] escaped) {

    /** @throws NoNumberException where a number is infinite or NaN */
    public EnergyLedger {
        for (double[] flux : new double[][] {emitted, shot, received, absorbed, unshot, escaped}) {
            NoNumberException.unlessNumbers("ledger", flux);
        }
    }

    /** A ledger of which it is not known what escaped. */
    public EnergyLedger(double[] emitted, double[] shot, double[] received, double[] absorbed, double[] unshot) {
        this(emitted, shot, received, absorbed, unshot, new double[0]);
    }

    /** Flux shot and not received, W: it left the scene, fell on an invisible side, or is an error of form factors. */
    public double deficit(int channel) {
        return shot[channel] - received[channel];
    }

    /** Whether it is known what escaped. */
    public boolean knowsEscaped() {
        return escaped.length > 0;
    }

    /** emitted - (absorbed + unshot + deficit), relative to the larger of emitted and shot; 0 but for rounding. */
    public double imbalance(int channel) {
        double difference = emitted[channel] - absorbed[channel] - unshot[channel] - deficit(channel);
        double scale = Math.max(emitted[channel], shot[channel]);
        return scale == 0 ? 0 : difference / scale;
    }
}
