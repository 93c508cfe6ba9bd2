package radiosity.output.gltf;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import radiosity.scene.Lamp;
import radiosity.scene.Rgb;
import radiosity.scene.SceneFormatException;
import radiosity.util.Decimal;

/**
 * What the light of each lamp of a scene is multiplied with; lamps with one name are one group. Immutable.
 *
 * @param lamps   of the scene
 * @param factors one per lamp, per channel, at least 0; 1 as rendered
 */
public record LampMix(List<Lamp> lamps, List<Rgb> factors) {

    private static final int CHANNELS = 3;
    /** Three factors and a name, which may be empty. */
    private static final Pattern LINE = Pattern.compile("\\s*(\\S+) +(\\S+) +(\\S+) (.*)");

    public static LampMix asRendered(List<Lamp> lamps) {
        return new LampMix(lamps, Collections.nCopies(lamps.size(), Rgb.grey(1)));
    }

    public boolean isAsRendered() {
        return equals(asRendered(lamps));
    }

    /** Names of the groups, in the order of their first lamps. */
    public List<String> groups() {
        return lamps.stream().map(Lamp::name).distinct().toList();
    }

    public Rgb factor(int group) {
        String name = groups().get(group);
        return factors.get(lamps.stream().map(Lamp::name).toList().indexOf(name));
    }

    public LampMix with(int group, Rgb factor) {
        return with(groups().get(group), factor);
    }

    private LampMix with(String name, Rgb factor) {
        List<Rgb> changed = new ArrayList<>(factors);
        for (int lamp = 0; lamp < changed.size(); lamp++) {
            if (lamps.get(lamp).name().equals(name)) {
                changed.set(lamp, factor);
            }
        }
        return new LampMix(lamps, changed);
    }

    /** With all other groups out; a group that is out itself gets the light as rendered. */
    public LampMix only(int group) {
        Rgb factor = factor(group).max() > 0 ? factor(group) : Rgb.grey(1);
        return new LampMix(lamps, Collections.nCopies(lamps.size(), Rgb.BLACK)).with(group, factor);
    }

    /** A line for each group: three factors and the name. */
    public String text() {
        StringBuilder text = new StringBuilder();
        List<String> names = groups();
        for (int group = 0; group < names.size(); group++) {
            Rgb factor = factor(group);
            text.append(factor.r()).append(' ').append(factor.g()).append(' ').append(factor.b()).append(' ')
                    .append(names.get(group)).append('\n');
        }
        return text.toString();
    }

    /**
     * The mix that a text from {@link #text()} describes; a name may be empty, or begin with a blank. Lamps that the
     * text does not name are as rendered, and names that the scene does not have are ignored.
     *
     * @param file name of the file, for messages
     */
    public LampMix read(String text, String file) throws SceneFormatException {
        LampMix mix = asRendered(lamps);
        String[] lines = text.split("\r?\n");
        for (int i = 0; i < lines.length; i++) {
            Matcher words = LINE.matcher(lines[i]);
            double[] factor = new double[CHANNELS];
            boolean isSound = words.matches();
            for (int c = 0; c < CHANNELS && isSound; c++) {
                factor[c] = Decimal.parse(words.group(c + 1));
                isSound = factor[c] >= 0 && factor[c] < Double.POSITIVE_INFINITY;
            }
            if (!isSound) {
                throw new SceneFormatException(file, "line " + (i + 1), "three factors and a lamp's name", lines[i]);
            }
            mix = mix.with(words.group(CHANNELS + 1), new Rgb(factor[0], factor[1], factor[2]));
        }
        return mix;
    }
}
