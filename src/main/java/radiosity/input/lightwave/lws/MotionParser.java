package radiosity.input.lightwave.lws;

import java.util.StringTokenizer;
import radiosity.input.file.Diagnostics;

/**
 * Reads motions and envelopes in three forms: LWSC 1 (keys of all channels together, times in frames), LWSC 2 (channel
 * after channel) and LWSC 3 and later (a block in braces per channel).
 *
 * <p>The number of keys that a file declares is ignored: keys are read as long as there are any.
 */
final class MotionParser {

    private static final int WORDS_OF_KEY = 9;

    private final SceneLines lines;
    private final int version;
    private final Diagnostics notes;

    MotionParser(SceneLines lines, int version, Diagnostics notes) {
        this.lines = lines;
        this.version = version;
        this.notes = notes;
    }

    /** Reads the lines after the first line of a motion or after "(envelope)". */
    Motion read() {
        if (!lines.next()) {
            return Motion.NONE;
        }
        boolean numbers = SceneNumbers.startsNumber(lines.line());
        lines.back();
        Envelope[] channels = new Envelope[Motion.CHANNELS];
        if (!numbers) {
            readBlocks(channels);
        } else if (version == 2) {
            readByChannel(channels);
        } else {
            readByKey(channels);
        }
        return new Motion(channels, version <= 2, numbers && version != 2);
    }

    private void readBlocks(Envelope[] channels) {
        int channel = 0;
        while (lines.next()) {
            String keyword = lines.keyword();
            if (keyword.equals("Channel")) {
                channel = (int) SceneNumbers.whole(lines.value(), 10);
            } else if (keyword.startsWith("{")) {
                Envelope envelope = readBlock();
                if (channel >= 0 && channel < channels.length) {
                    channels[channel] = envelope;
                }
                channel++;
            } else if (!keyword.equals("NumChannels")) {
                lines.back();
                return;
            }
        }
    }

    /** Reads a block whose opening brace has been read. */
    private Envelope readBlock() {
        Envelope envelope = new Envelope();
        while (lines.next()) {
            switch (lines.keyword()) {
                case "Key" -> add(envelope, SceneNumbers.all(lines.value(), WORDS_OF_KEY));
                case "Behaviors" -> behaviours(envelope, SceneNumbers.all(lines.value(), 2));
                case "}" -> {
                    return envelope;
                }
                case "Channel", "LoadObject", "LoadObjectLayer", "AddNullObject", "AddLight", "AddCamera" -> {
                    notes.note(lines.place(), "a block has no closing brace");
                    lines.back();
                    return envelope;
                }
                default -> nested();
            }
        }
        return envelope;
    }

    private void nested() {
        if (lines.keyword().startsWith("{")) {
            lines.back();
            skipBlock();
        }
    }

    /** Skips from the opening brace on the next line to its closing brace. */
    void skipBlock() {
        int depth = 0;
        while (lines.next()) {
            String line = lines.line();
            depth += line.startsWith("{") ? 1 : 0;
            depth -= line.equals("}") || line.startsWith("{") && line.endsWith(" }") ? 1 : 0;
            if (depth == 0) {
                return;
            }
        }
        notes.note(lines.place(), "a block has no closing brace");
    }

    /** Reads per key a line with the values of all channels and one with frame, linear, tension, continuity, bias. */
    private void readByKey(Envelope[] channels) {
        int count = count(channels.length);
        skipNumber();
        while (nextNumbers()) {
            double[] values = SceneNumbers.all(lines.line(), count);
            if (!nextNumbers()) {
                break;
            }
            double[] how = SceneNumbers.all(lines.line(), 5);
            for (int c = 0; c < values.length; c++) {
                channels[c] = channels[c] == null ? new Envelope() : channels[c];
                add(channels[c], oldKey(values[c], how));
            }
        }
        if (lines.keyword().equals("EndBehavior")) {
            double[] after = SceneNumbers.all(lines.value(), 1);
            for (int c = 0; c < count && channels[c] != null && after.length == 1; c++) {
                behaviours(channels[c], new double[] {1, after[0]});
            }
        } else {
            notes.note(lines.place(), "a motion has no EndBehavior");
            lines.back();
        }
    }

    private static double[] oldKey(double value, double[] how) {
        double[] key = new double[Envelope.PER_KEY];
        key[0] = value;
        key[1] = how.length > 0 ? how[0] : 0;
        key[2] = how.length > 1 && how[1] == 1 ? Envelope.LINEAR : Envelope.TCB;
        System.arraycopy(how, Math.min(2, how.length), key, 3, Math.max(0, how.length - 2));
        return key;
    }

    /** Reads per channel a line with the number of keys, then a line per key. */
    private void readByChannel(Envelope[] channels) {
        int count = count(channels.length);
        int channel = -1;
        while (nextNumbers()) {
            if (new StringTokenizer(lines.line()).countTokens() == 1) {
                channel++;
            } else if (channel >= 0 && channel < count) {
                channels[channel] = channels[channel] == null ? new Envelope() : channels[channel];
                add(channels[channel], SceneNumbers.all(lines.line(), WORDS_OF_KEY));
            }
        }
        if (lines.keyword().equals("Pre/PostBehavior")) {
            double[] all = SceneNumbers.all(lines.value(), 2 * count);
            for (int c = 0; 2 * c + 1 < all.length; c++) {
                if (channels[c] != null) {
                    behaviours(channels[c], new double[] {all[2 * c], all[2 * c + 1]});
                }
            }
        } else {
            lines.back();
        }
    }

    private int count(int most) {
        lines.next();
        long count = SceneNumbers.whole(lines.line(), 10);
        return (int) Math.max(1, Math.min(most, count));
    }

    private void skipNumber() {
        if (nextNumbers() && new StringTokenizer(lines.line()).countTokens() > 1) {
            lines.back();
        }
    }

    /** Moves to the next line; false if it does not begin with a number. */
    private boolean nextNumbers() {
        return lines.next() && SceneNumbers.startsNumber(lines.line());
    }

    private void add(Envelope envelope, double[] key) {
        if (key.length < 1 || Double.isNaN(key[0]) || key.length > 1 && Double.isNaN(key[1])) {
            notes.note(lines.place(), "keys without numbers are left out", lines.line());
            return;
        }
        for (int i = 0; i < key.length; i++) {
            key[i] = Double.isNaN(key[i]) ? 0 : key[i];
        }
        envelope.add(key);
    }

    private static void behaviours(Envelope envelope, double[] numbers) {
        if (numbers.length == 2 && !Double.isNaN(numbers[0] + numbers[1])) {
            envelope.behaviours((int) numbers[0], (int) numbers[1]);
        }
    }
}
