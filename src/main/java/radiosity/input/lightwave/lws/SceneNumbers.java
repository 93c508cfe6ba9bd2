package radiosity.input.lightwave.lws;

import java.util.StringTokenizer;
import radiosity.util.Decimal;

/** Reads numbers from a scene's lines in all notations that versions of LightWave wrote. */
public final class SceneNumbers {

    private SceneNumbers() {
    }

    /** The numbers of a line, at most n; NaN for words that are not finite numbers. */
    static double[] all(String text, int n) {
        StringTokenizer words = new StringTokenizer(text);
        double[] numbers = new double[Math.min(n, words.countTokens())];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = one(words.nextToken());
        }
        return numbers;
    }

    /** A number with a decimal point or comma; NaN for a word that is not a finite number ("1.#IND"). */
    public static double one(String word) {
        return Decimal.parse(word.replace(',', '.'));
    }

    /** Whether a line begins as a number does. */
    static boolean startsNumber(String line) {
        char c = line.charAt(0);
        return c >= '0' && c <= '9' || c == '-' || c == '+' || c == '.';
    }

    /** A whole number in some base; -1 for a text that is not a whole number or out of range. */
    static long whole(String word, int base) {
        try {
            return Long.parseLong(word.trim(), base);
        } catch (NumberFormatException e) {
            return -1;
        }
    }
}
