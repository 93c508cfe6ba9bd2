package radiosity.edit.model;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import radiosity.input.lightwave.lws.SceneNumbers;

/** The text of a LightWave scene in which single numbers and paths can be replaced; all other bytes stay the same. */
final class MotionLines {

    private static final Pattern LINE = Pattern.compile("[^\\r\\n]*(\\r\\n|\\r|\\n|$)");
    private static final Pattern KEY = Pattern.compile("\\s*Key\\s+(\\S+)\\s.*", Pattern.DOTALL);
    private static final Pattern CHANNEL = Pattern.compile("\\s*Channel\\s+(\\d+)\\s*");
    private static final Pattern NUMBERS = Pattern.compile("\\s*[-+.\\d].*", Pattern.DOTALL);
    private static final int CHANNELS = 9;
    private static final int BLOCKS = 3;

    /** Lines with their line ends. */
    private final List<String> lines = new ArrayList<>();
    private final int version;

    /** @param text the whole file, one character per byte */
    MotionLines(String text) {
        Matcher matcher = LINE.matcher(text);
        while (matcher.find() && matcher.end() > matcher.start()) {
            lines.add(matcher.group());
        }
        version = lines.stream().map(String::trim).filter(line -> line.matches("\\d+")).findFirst()
                .map(Integer::parseInt).orElse(0);
    }

    String text() {
        return String.join("", lines);
    }

    /**
     * Replaces the path of an object's file.
     *
     * @param line    number of the line that loads the object, from 1
     * @param written path in that line
     * @param other   path to replace it with
     */
    void file(int line, String written, String other) {
        String text = lines.get(line - 1);
        int at = text.lastIndexOf(written);
        if (at < 0) {
            throw new IllegalArgumentException("line " + line + ": expected " + written + ", got " + text.trim());
        }
        lines.set(line - 1, text.substring(0, at) + other + text.substring(at + written.length()));
    }

    /** A number of a motion: its line, from 0, and its first and last character, the last exclusive. */
    private record Place(int line, int from, int to) { }

    /**
     * Adds offsets to the position and heading of an object, in all keys.
     *
     * @param line     number of the line with which the object begins, from 1
     * @param position 3, scene units, left-handed
     * @param heading  radians
     * @throws IllegalArgumentException where the object has no keys, or several keys and is to turn
     */
    void add(int line, double[] position, double heading) {
        List<List<Place>> channels = channels(line);
        boolean isAnimated = channels.stream().limit(3).anyMatch(places -> places.size() > 1);
        if (heading != 0 && isAnimated) {
            throw new IllegalArgumentException("line " + line + ": expected an object of one key to turn, got an"
                    + " animated one");
        }
        for (int c = 3; c >= 0; c--) { // backwards: earlier places in the same line stay valid
            double by = c < 3 ? position[c] : version < BLOCKS ? Math.toDegrees(heading) : heading;
            if (by != 0 && channels.get(c).isEmpty()) {
                throw new IllegalArgumentException("line " + line + ": expected an object with keys, got none");
            }
            for (Place place : channels.get(c)) {
                String text = lines.get(place.line);
                if (by != 0) {
                    boolean isComma = text.substring(place.from, place.to).indexOf(',') >= 0;
                    String value = Double.toString(number(place) + by).replace('.', isComma ? ',' : '.');
                    lines.set(place.line, text.substring(0, place.from) + value + text.substring(place.to));
                }
            }
        }
    }

    /** Returns x, y, z in the parent's space, left-handed, by the object's first keys; 0 without keys. */
    double[] position(int line) {
        List<List<Place>> channels = channels(line);
        double[] position = new double[3];
        for (int c = 0; c < 3 && !channels.get(c).isEmpty(); c++) {
            position[c] = number(channels.get(c).get(0));
        }
        return position;
    }

    private double number(Place place) {
        String word = lines.get(place.line).substring(place.from, place.to);
        double number = SceneNumbers.one(word);
        if (Double.isNaN(number)) {
            throw new IllegalArgumentException("line " + (place.line + 1) + ": expected a number, got " + word);
        }
        return number;
    }

    private List<List<Place>> channels(int line) {
        return version >= BLOCKS ? blocks(motion(line)) : keys(motion(line));
    }

    /** Returns the index of the line after the one with which an object's motion begins. */
    private int motion(int line) {
        for (int i = line; i < lines.size(); i++) {
            String text = lines.get(i).trim();
            if (text.startsWith("ObjectMotion")) {
                return i + 1;
            }
            if (text.startsWith("LoadObject") || text.startsWith("Add")) {
                break;
            }
        }
        throw new IllegalArgumentException("line " + line + ": expected an object with a motion, got none");
    }

    private static List<List<Place>> none() {
        List<List<Place>> channels = new ArrayList<>();
        for (int c = 0; c < CHANNELS; c++) {
            channels.add(new ArrayList<>());
        }
        return channels;
    }

    /** Finds the keys of version 3 and later: each channel has a block in braces. */
    private List<List<Place>> blocks(int from) {
        List<List<Place>> channels = none();
        int channel = -1;
        int depth = 0;
        for (int i = from; i < lines.size(); i++) {
            String text = lines.get(i).trim();
            Matcher begin = CHANNEL.matcher(text);
            Matcher key = KEY.matcher(lines.get(i));
            if (begin.matches()) {
                channel = Integer.parseInt(begin.group(1));
            } else if (text.startsWith("{")) {
                depth++;
            } else if (text.startsWith("}")) {
                depth--;
            } else if (depth == 1 && channel >= 0 && channel < CHANNELS && key.matches()) {
                channels.get(channel).add(new Place(i, key.start(1), key.end(1)));
            } else if (depth == 0 && !text.isEmpty() && !text.startsWith("NumChannels")) {
                break;
            }
        }
        return channels;
    }

    /** Finds the keys of version 1: after two counts, a line of nine numbers and a line of the time per key. */
    private List<List<Place>> keys(int from) {
        if (version != 1) {
            throw new IllegalArgumentException("expected a scene of LWSC 1, or of 3 and later, got version " + version);
        }
        List<List<Place>> channels = none();
        for (int i = from + 2; i < lines.size() && NUMBERS.matcher(lines.get(i)).matches(); i += 2) {
            Matcher word = Pattern.compile("\\S+").matcher(lines.get(i));
            for (int c = 0; c < CHANNELS && word.find(); c++) {
                channels.get(c).add(new Place(i, word.start(), word.end()));
            }
        }
        return channels;
    }
}
