package radiosity.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * The references computed here agree with values computed elsewhere from the same closed form, to all printed digits.
 * For 5.7 with the box these are the corrected Table 19; the one printed in CIE 171:2006 is wrong (I. Ashdown, CIE
 * 171:2006 errata).
 */
class CieReferenceTest {

    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {
        "5.3; A 32.6769 B 75.1939 C 81.3232 D 69.0606 E 53.4035 F 40.0019 G 61.4241 H 79.2552 I 95.6673 J 105.7782",
        "5.6 horizontal reflector, side 4.0 m, wall; B 35.9005 C 27.9916 D 21.6385 E 16.7163 F 12.9674",
        "5.6 horizontal reflector, side 4.0 m, ceiling; G 26.7952 H 30.9387 I 33.9757 J 35.5666 K 35.5666 N 26.7952",
        "5.6 horizontal reflector, side 0.5 m, wall; B .5799 C .6444 D .5564 E .4333 F .3251",
        "5.6 horizontal reflector, side 0.5 m, ceiling; G .4914 H .6391 I .7776 J .8643",
        "5.6 horizontal reflector, side 500.0 m, wall; B 49.8305",
        "5.6 horizontal reflector, side 500.0 m, ceiling; G 99.9882",
        "5.7 vertical reflector, with box; A 16.0706 B 16.3297 C 15.3988 D 13.3220 E 10.3169 F 7.0790 G 3.3823 "
            + "H 3.6290 I 3.0130 J 0 K 0",
        "5.7 vertical reflector, without; A 16.6100 B 18.0938 C 18.8976",
        "5.9 uniform sky, opening 1.0; A 1.0401 B 2.3935 C 2.5886 D 2.1983 E 1.6999 F 1.2733 G 1.9552 H 2.5228 "
            + "I 3.0452 J 3.3670",
        "5.9 uniform sky, opening 4.0; A 45.1226 B 35.9005 C 27.9916 G 26.7952 H 30.9387 I 33.9757 J 35.5666"})
    void closedForm_givesThePublishedDigits(String name, String values) {
        CieCase found = Cie.cases().stream().filter(c -> c.name().startsWith(name)).findFirst().orElseThrow();
        String[] words = values.trim().split(" +");
        for (int i = 0; i < words.length; i += 2) {
            assertEquals(Double.parseDouble(words[i + 1]), found.point(words[i]).irradiance(), 5.001e-5, words[i]);
        }
    }
}
