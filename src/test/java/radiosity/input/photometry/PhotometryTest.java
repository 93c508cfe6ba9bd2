package radiosity.input.photometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.DoubleBinaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import radiosity.scene.LuminousIntensity;
import radiosity.scene.SceneFormatException;

/**
 * Files of every edition, photometric type and symmetry.
 *
 * <p>A direction is (down, zero, across): of C and gamma (cos gamma, sin gamma cos C, sin gamma sin C); of type A (cos V
 * cos H, sin V, -cos V sin H); of type B (cos H cos V, cos H sin V, -sin H), as A and B count H clockwise.
 */
class PhotometryTest {

    private static final String C_OF_2002 = "IESNA:LM-63-2002\n[TEST] by hand\n[LUMINAIRE] none\n";

    private static Photometry read(String text) throws IOException {
        return Photometry.of(text.getBytes(StandardCharsets.ISO_8859_1), "lamp.ies");
    }

    private static double[] from(double first, double step, double last) {
        return IntStream.rangeClosed(0, (int) Math.round((last - first) / step)).mapToDouble(i -> first + i * step)
                .toArray();
    }

    private static String text(double... numbers) {
        StringBuilder text = new StringBuilder();
        for (double number : numbers) {
            text.append(number).append(text.length() % 7 == 0 ? ",\r\n" : " ");
        }
        return text.append("\n").toString();
    }

    private static String ies(String head, int type, double[] h, double[] v, DoubleBinaryOperator candela) {
        double[] values = IntStream.range(0, h.length * v.length)
                .mapToDouble(i -> candela.applyAsDouble(h[i / v.length], v[i % v.length])).toArray();
        return head + "TILT=NONE\n1 1000 2 " + v.length + " " + h.length + " " + type + " 2 .3 .6 0\n.5 1 30\n" + text(v)
                + text(h) + text(values);
    }

    @ParameterizedTest
    @CsvSource({"'label\nanother label\n', 0.9", "'IESNA91\n[TEST] 1\n', 0.9", "'IESNA:LM-63-1995\n[TEST] 1\n', 1",
        "'IESNA:LM-63-2002\n[TEST] 1\n', 1", "'IES:LM-63-2019\n[TEST] 1\n', 1"})
    void everyEdition_isRead_withItsOwnMeaningOfTheSecondFactor(String head, double factor) throws IOException {
        String text = ies(head, 1, new double[] {0}, from(0, 30, 180), (c, g) -> 100 + g).replace(".5 1 30", ".5 .9 30");
        Photometry lamp = read(text);
        assertEquals(factor * 130, lamp.intensity().at(77, 30), 1e-9);
        assertEquals(factor * 145, lamp.intensity().at(77, 45), 1e-9);
        assertEquals(.6, lamp.length());
        assertEquals(.3, lamp.width());
    }

    /** Each listed range of planes, with intensities that have its symmetry. */
    @ParameterizedTest
    @CsvSource({"0, 30, 90", "0, 30, 180", "0, 30, 360", "0, 30, 330", "90, 30, 270"})
    void everySymmetryOfTypeC_isUnfolded(double first, double step, double last) throws IOException {
        DoubleBinaryOperator candela = (c, g) -> {
            double cos = Math.cos(Math.toRadians(c));
            double sin = Math.sin(Math.toRadians(c));
            double bend = last == 90 ? cos * cos : last == 180 ? cos : last == 270 ? sin : cos + 0.3 * sin;
            return 100 + 0.5 * g + 20 * bend * Math.sin(Math.toRadians(g));
        };
        LuminousIntensity web = read(ies(C_OF_2002, 1, from(first, step, last), from(0, 15, 180), candela)).intensity();
        for (double c = -360; c <= 360; c += 30) {
            for (double g = 15; g < 180; g += 15) {
                double sin = Math.sin(Math.toRadians(g));
                double found = web.towards(3 * Math.cos(Math.toRadians(g)), 3 * sin * Math.cos(Math.toRadians(c)),
                        3 * sin * Math.sin(Math.toRadians(c)));
                assertEquals(candela.applyAsDouble(c, g), found, 1e-9, "C " + c + ", gamma " + g);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"2, 0, 0", "2, -90, -90", "2, -90, 0", "3, 0, 0", "3, -90, -90", "3, 0, -90"})
    void typesAAndB_areTurnedRightly(int type, double firstH, double firstV) throws IOException {
        DoubleBinaryOperator candela = (h, v) -> 500 - Math.abs(h) - 2 * Math.abs(v) + (firstH < 0 ? h / 2 : 0)
                + (firstV < 0 ? v / 4 : 0);
        LuminousIntensity web = read(ies(C_OF_2002, type, from(firstH, 10, 90), from(firstV, 10, 90), candela))
                .intensity();
        for (double h = -80; h <= 80; h += 10) {
            for (double v = -80; v <= 80; v += 10) {
                double sh = Math.sin(Math.toRadians(h));
                double ch = Math.cos(Math.toRadians(h));
                double sv = Math.sin(Math.toRadians(v));
                double cv = Math.cos(Math.toRadians(v));
                double found = type == 3 ? web.towards(cv * ch, sv, -cv * sh) : web.towards(ch * cv, ch * sv, -sh);
                assertEquals(candela.applyAsDouble(h, v), found, 1e-9, "H " + h + ", V " + v);
            }
        }
        assertEquals(0, web.towards(-1, 0.01, 0.01), "behind it");
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4})
    void everySymmetryOfEulumdat_isUnfolded(int symmetry) throws IOException {
        DoubleBinaryOperator perKilolumen = (c, g) -> {
            double cos = Math.cos(Math.toRadians(c));
            double sin = Math.sin(Math.toRadians(c));
            double bend = symmetry == 1 ? 1 : symmetry == 2 ? cos : symmetry == 3 ? sin : symmetry == 4 ? cos * cos
                    : cos + 0.3 * sin;
            return 100 + 0.5 * g + 20 * bend;
        };
        Photometry lamp = Photometry.of(eulumdat(symmetry, perKilolumen).getBytes(StandardCharsets.ISO_8859_1), "l.ldt");
        for (double c = 0; c < 360; c += 30) {
            for (double g = 0; g <= 180; g += 15) {
                assertEquals(2.5 * perKilolumen.applyAsDouble(c, g), lamp.intensity().at(c, g), 1e-3);
            }
        }
        assertEquals(1.2, lamp.width(), 1e-12, "the length lies across the plane C0");
        assertEquals(.3, lamp.length(), 1e-12);
    }

    /** The first line of EULUMDAT is the name of a company. */
    @Test
    void eulumdatOfACompanyCalledIes_isRead() throws IOException {
        String file = eulumdat(1, (c, g) -> 100).replaceFirst("maker", "IES Leuchten GmbH");
        assertEquals(250, Photometry.of(file.getBytes(StandardCharsets.ISO_8859_1), "l.ldt").intensity().at(0, 0), 1e-3);
    }

    /** 12 planes, 13 angles, two sets of lamps of which the first has 2500 lm. */
    private static String eulumdat(int symmetry, DoubleBinaryOperator candela) {
        List<String> lines = new ArrayList<>(List.of("maker", "1", String.valueOf(symmetry), "12", "30", "13", "15", "",
                "lamp", "1", "lamp.ldt", "2026", "1250", "350", "80", "1200", "300", "0", "0", "0", "0", "100", "80",
                "1", "0", "2", "1", "LED", "2500", "4000", "80", "20", "2", "LED", "5000", "4000", "80", "40"));
        lines.addAll(List.of("0", "0", "0", "0", "0", "0", "0", "0", "0", "0"));
        for (double angle : from(0, 30, 330)) {
            lines.add(String.valueOf(angle).replace('.', ','));
        }
        for (double angle : from(0, 15, 180)) {
            lines.add(String.valueOf(angle));
        }
        int first = symmetry == 3 ? 9 : 0;
        int count = new int[] {12, 1, 7, 7, 4}[symmetry];
        for (int i = first; i < first + count; i++) {
            for (double angle : from(0, 15, 180)) {
                lines.add(String.valueOf(candela.applyAsDouble(i % 12 * 30, angle)).replace('.', ','));
            }
        }
        return String.join("\r\n", lines) + "\r\n";
    }

    @Test
    void tilt_isRead_fromTheFileAndFromOneBesideIt(@TempDir Path folder) throws IOException {
        String lamp = ies(C_OF_2002, 1, new double[] {0}, from(0, 90, 90), (c, g) -> 100);
        String factors = "1\n3\n0 45 90\n1 .8 .5\n";
        Photometry included = read(lamp.replace("TILT=NONE\n", "TILT=INCLUDE\n" + factors));
        assertEquals(.9, included.tilt().factor(22.5), 1e-12);
        assertEquals(.5, included.tilt().factor(120), 1e-12);
        Files.writeString(folder.resolve("lamp.tlt"), factors);
        Files.writeString(folder.resolve("lamp.ies"), lamp.replace("=NONE", "=C:\\tilts\\lamp.tlt"));
        assertEquals(.65, Photometry.read(folder.resolve("lamp.ies"), 10_000).tilt().factor(67.5), 1e-12);
        assertTrue(assertThrows(SceneFormatException.class, () -> read(lamp.replace("=NONE", "=none.tlt"))).getMessage()
                .contains("none.tlt"));
    }

    @ParameterizedTest
    @CsvSource({"1 .5 1 0, .3048, .1524", "2 -.5 0 0, .443113, .443113", "2 -.5 -1 0, .886227, .443113",
        "2 0 0 0, 0, 0"})
    void luminousOpening_isInMetres_roundOnesAsLargeAsARectangle(String opening, double length, double width)
            throws IOException {
        Photometry lamp = read(ies(C_OF_2002, 1, new double[] {0}, from(0, 90, 90), (c, g) -> 1)
                .replace("2 .3 .6 0", opening));
        assertEquals(length, lamp.length(), 1e-6);
        assertEquals(width, lamp.width(), 1e-6);
    }

    /** 4 pi I, and of I cos(gamma), which is interpolated over each degree, pi I. */
    /** The plane of 360 degrees, which is that of 0, may be left out; more may not. */
    @Test
    void horizontalAngles_thatLeaveOutAPartOfTheCircle_areRefused() throws IOException {
        for (double[] angles : List.of(from(0, 45, 270), from(0, 22.5, 45), from(0, 30, 210))) {
            assertThrows(SceneFormatException.class,
                    () -> read(ies(C_OF_2002, 1, angles, from(0, 15, 90), (c, g) -> 100)), Arrays.toString(angles));
        }
        for (double[] angles : List.of(from(0, 90, 270), from(0, 15, 345), from(0, 15, 360))) {
            assertEquals(100, read(ies(C_OF_2002, 1, angles, from(0, 15, 90), (c, g) -> 100)).intensity().at(
                    Math.toRadians(350), .1), 1e-9);
        }
    }

    @Test
    void flux_isIntegrated() throws IOException {
        double even = read(ies(C_OF_2002, 1, new double[] {0}, from(0, 90, 180), (c, g) -> 7)).intensity().flux();
        assertEquals(4 * Math.PI * 7, even, 1e-9);
        double lambert = read(ies(C_OF_2002, 1, from(0, 90, 360), from(0, 1, 90),
                (c, g) -> Math.max(0, Math.cos(Math.toRadians(g))))).intensity().flux();
        assertEquals(Math.PI, lambert, 1e-4);
    }

    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {"TILT=NONE; TLIT=NONE", "TILT=NONE; TILT=", " 2 .3 .6; x .3 .6",
        "1 1000 2 3; 1 1000 2 3000000", "1 1000 2 3; 1 1000 2 2.5", "1 1000 2 3; 1 1000 2 -3", "1 1000 2 3; 1 1000 NaN 3",
        "1 1000 2 3; 1 1000 -2 3", " 3 1 1 2; 3 1 7 2", " 3 1 1 2; 3 1 1 9", "90.0 180.0; 180.0 90.0",
        "90.0 180.0; 90.0 181.0", "7.0; -7.0", "7.0; 7e99999", ".5 1 30; .5 1"})
    void brokenFiles_areRefusedInALine(String right, String wrong) throws IOException {
        String sound = ies(C_OF_2002, 1, new double[] {0}, from(0, 90, 180), (c, g) -> 7)
                .replaceAll(",\r\n", " ");
        read(sound);
        assertTrue(sound.contains(right), sound);
        refused(sound.replace(right, wrong));
        refused(sound.substring(0, sound.length() - 6));
    }

    @ParameterizedTest
    @CsvSource({"3, 7", "4, 0", "4, 10", "6, 1", "26, 0", "27, 0", "29, 0", "29, -5", "24, x", "50, 400", "70, 1", "80, -1",
        "80, "})
    void brokenEulumdat_isRefusedInALine(int line, String wrong) {
        String[] lines = eulumdat(2, (c, g) -> 10).split("\r\n");
        lines[line - 1] = wrong == null ? "" : wrong;
        String message = refused(String.join("\n", lines));
        assertTrue(message.startsWith("lamp.ies"), message);
    }

    private static String refused(String text) {
        String message = assertThrows(SceneFormatException.class, () -> read(text)).getMessage();
        assertFalse(message.contains("\n"), message);
        assertTrue(message.contains(": expected ") && message.contains(", got "), message);
        return message;
    }

    /** Bytes changed, cut, doubled and swapped: each mutant is read, or refused in a line. */
    @Test
    void twoThousandMutants_areReadOrRefused() throws IOException {
        List<byte[]> sound = new ArrayList<>();
        sound.add(ies(C_OF_2002, 1, from(0, 30, 360), from(0, 15, 180), (c, g) -> 10 + g).getBytes(
                StandardCharsets.ISO_8859_1));
        sound.add(ies("", 2, from(-90, 30, 90), from(0, 15, 90), (c, g) -> 10 + g).replace("=NONE",
                "=INCLUDE\n1 2 0 90 1 1").getBytes(StandardCharsets.ISO_8859_1));
        sound.add(eulumdat(3, (c, g) -> 10 + g).getBytes(StandardCharsets.ISO_8859_1));
        Random random = new Random(23);
        int refused = 0;
        for (int i = 0; i < 2000; i++) {
            byte[] mutant = mutant(sound.get(i % 3).clone(), random);
            try {
                Photometry lamp = Photometry.of(mutant, "mutant");
                assertTrue(lamp.intensity().max() >= 0 && lamp.length() >= 0 && lamp.width() >= 0);
            } catch (SceneFormatException e) {
                assertFalse(e.getMessage().contains("\n"), e.getMessage());
                refused++;
            }
        }
        assertTrue(refused > 200 && refused < 2000, "refused: " + refused);
    }

    private static byte[] mutant(byte[] bytes, Random random) {
        byte[] of = random.nextInt(4) == 0 ? java.util.Arrays.copyOf(bytes, random.nextInt(bytes.length)) : bytes;
        for (int k = random.nextInt(4); k >= 0 && of.length > 0; k--) {
            int at = random.nextInt(of.length);
            of[at] = random.nextBoolean() ? (byte) random.nextInt(256) : of[random.nextInt(of.length)];
        }
        return of;
    }
}
