package radiosity.input.lightwave.lws;

import java.util.StringTokenizer;

/** Reads the numbers of a scene's lines as thirty years of programs wrote them. */
final class SceneNumbers {

    private SceneNumbers() {
    }

    /** The numbers of a line, at most n; NaN for what is no finite number. */
    static double[] all(String text, int n) {
        StringTokenizer words = new StringTokenizer(text);
        double[] numbers = new double[Math.min(n, words.countTokens())];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = one(words.nextToken());
        }
        return numbers;
    }

    /** A number; with a decimal comma too. NaN for what is none or not finite ("1.#IND"). */
    static double one(String word) {
        if (!word.chars().allMatch(c -> c >= '0' && c <= '9' || "+-.,eE".indexOf(c) >= 0)) {
            return Double.NaN;
        }
        try {
            double number = Double.parseDouble(word.replace(',', '.'));
            return Double.isFinite(number) ? number : Double.NaN;
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }

    /** Whether a line begins as a number does. */
    static boolean startsNumber(String line) {
        char c = line.charAt(0);
        return c >= '0' && c <= '9' || c == '-' || c == '+' || c == '.';
    }

    /** A whole number in some base; -1 if it is none or out of range. */
    static long whole(String word, int base) {
        try {
            return Long.parseLong(word.trim(), base);
        } catch (NumberFormatException e) {
            return -1;
        }
    }
}
