package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;
import radiosity.cli.options.CalculationOptions;
import radiosity.cli.options.CommandLineParser;
import radiosity.cli.options.ExitCode;
import radiosity.cli.options.Failure;
import radiosity.cli.options.RendererOptions;
import radiosity.cli.options.ServerOptions;
import radiosity.cli.options.ViewOptions;
import radiosity.settings.RadiositySettings;
import radiosity.settings.Schedule;

/** What a command line means, and what is said about a wrong one: one line each, before any work. */
class CommandLineTest {

    private static RendererOptions parse(String commandLine) {
        RendererOptions options = new RendererOptions();
        new CommandLineParser(options).parse(commandLine.split(" "));
        options.check();
        return options;
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            -pa -3 a b             | -pa: expected a number above 0, got -3
            -pa 0 a b              | -pa: expected a number above 0, got 0
            -pa NaN a b            | -pa: expected a number above 0, got NaN
            -pa Infinity a b       | -pa: expected a number above 0, got Infinity
            -pa 1e999 a b          | -pa: expected a number above 0, got 1e999
            -pa 1e-999 a b         | -pa: expected a number above 0, got 1e-999
            -pa 0x1p3 a b          | -pa: expected a number above 0, got 0x1p3
            -pa x a b              | -pa: expected a number above 0, got x
            -pa 0% a b             | -pa: expected a number above 0, got 0%
            -pa 101% a b           | -pa: expected a number above 0, got 101%
            -pa % a b              | -pa: expected a number above 0, got %
            -pa                    | -pa: expected a number above 0, got nothing
            -pa -nr 5 a b          | -pa: expected a number above 0, got nothing
            -pa 1 -pa 2 a b        | -pa: expected once, got twice
            -pa 1 --patch-area 2 a | -pa: expected once, got twice
            -nr 0 a b              | -nr: expected a whole number from 1 to 1000000, got 0
            -nr -1 a b             | -nr: expected a whole number from 1 to 1000000, got -1
            -nr 1.5 a b            | -nr: expected a whole number from 1 to 1000000, got 1.5
            -nr 1000001 a b        | -nr: expected a whole number from 1 to 1000000, got 1000001
            -nr 99999999999 a b    | -nr: expected a whole number from 1 to 1000000, got 99999999999
            -nr NaN a b            | -nr: expected a whole number from 1 to 1000000, got NaN
            -nr                    | -nr: expected a whole number from 1 to 1000000, got nothing
            -mt -1 a b             | -mt: expected a number of at least 0, got -1
            -mt NaN a b            | -mt: expected a number of at least 0, got NaN
            -mt x a b              | -mt: expected a number of at least 0, got x
            -mt                    | -mt: expected a number of at least 0, got nothing
            -it -1 a b             | -it: expected a whole number of at least 0, got -1
            -it x a b              | -it: expected a whole number of at least 0, got x
            -it                    | -it: expected a whole number of at least 0, got nothing
            -se -0.1 a b           | -se: expected a number from 0 to 1, got -0.1
            -se 1.1 a b            | -se: expected a number from 0 to 1, got 1.1
            -se NaN a b            | -se: expected a number from 0 to 1, got NaN
            -se                    | -se: expected a number from 0 to 1, got nothing
            --accuracy 0 a b       | --accuracy: expected per cent above 0 and up to 100, like 2%, got 0
            --accuracy 1 a b       | --accuracy: expected per cent above 0 and up to 100, like 2%, got 1; 1% or 0.01?
            --accuracy .5 a b      | --accuracy: expected per cent above 0 and up to 100, like 2%, got .5; .5% or 0.005?
            --accuracy -1% a b     | --accuracy: expected per cent above 0 and up to 100, like 2%, got -1%
            --accuracy 101% a b    | --accuracy: expected per cent above 0 and up to 100, like 2%, got 101%
            --accuracy NaN a b     | --accuracy: expected per cent above 0 and up to 100, like 2%, got NaN
            --accuracy             | --accuracy: expected per cent above 0 and up to 100, like 2%, got nothing
            --time 0s a b          | --time: expected a time above 0 like 60s, 500ms, 2m or 1h, got 0s
            --time -1s a b         | --time: expected a time above 0 like 60s, 500ms, 2m or 1h, got -1s
            --time 3 min a b       | files: expected a scene to read and a scene file to write, got min a b
            --time 1d a b          | --time: expected a time above 0 like 60s, 500ms, 2m or 1h, got 1d
            --time s a b           | --time: expected a time above 0 like 60s, 500ms, 2m or 1h, got s
            --time 1e9s a b        | --time: expected a time above 0 like 60s, 500ms, 2m or 1h, got 1e9s
            --time                 | --time: expected a time above 0 like 60s, 500ms, 2m or 1h, got nothing
            --time 1 --accuracy 1% a b | --time: expected without --accuracy, got both
            --time 1 -tf a 3 a b   | --time: expected without -tf, got both
            --time 1 -si 3 a b     | --time: expected without -si, got both
            --time 1 -sn 3 a b     | --time: expected without -sn, got both
            --time 1 -dr a b       | --time: expected without -dr, got both
            -dr -sn 1 a b          | -dr: expected without -sn, got both
            -dr -si 1 a b          | -dr: expected without -si, got both
            -si 0 a b              | -si: expected a whole number of at least 1, got 0
            -si                    | -si: expected a whole number of at least 1, got nothing
            -sn 0 a b              | -sn: expected a whole number of at least 1, got 0
            -sn -5 a b             | -sn: expected a whole number of at least 1, got -5
            -sn                    | -sn: expected a whole number of at least 1, got nothing
            -t 0 a b               | -t: expected a whole number of at least 1, got 0
            -t                     | -t: expected a whole number of at least 1, got nothing
            -tf                    | -tf: expected a scene file, got nothing
            -tf f a                | files: expected a scene to read and a scene file to write, got a
            -tf f x a b            | files: expected a scene to read and a scene file to write, got x a b
            -tf f 1.5 a b          | -tf: expected a whole number of at least 0, got 1.5
            -tf f -1 a b           | -tf: expected a whole number of at least 0, got -1
            -tf f 1 -tf f 1 a b    | -tf: expected once, got twice
            -ut 0 a b              | -ut: expected a number above 0, got 0
            -ut                    | -ut: expected a number above 0, got nothing
            -h                     | -h: expected the number of hosts and their names, as in -h 3 andreas daniel igge (see --help), got nothing
            -h 0 a b               | -h: expected a whole number of at least 1, got 0
            -h -1 a b              | -h: expected a whole number of at least 1, got -1
            -h andreas a b         | -h: expected a whole number of at least 1, got andreas
            -h 3 a b               | -h: expected the names of 3 hosts, got 2
            -h 3 a b x.lws o.scene | -h: expected the names of 3 hosts, got 2 before x.lws
            -h 2 a b c             | files: expected a scene to read and a scene file to write, got c; hosts are a, b
            -h 2 a -q b c          | -h: expected the names of 2 hosts, got 1 before -q
            -h 1 a -h 1 b c d      | -h: expected once, got twice
            -h 2 igge IGGE a b     | -h: expected every host once, got IGGE twice
            -q -q a b              | -q: expected once, got twice
            -q=3 a b               | -q: expected no value, got 3
            --schedule x a b       | --schedule: expected predict, paper, shooting, gathering or matrix, got x
            --schedule PAPER a b   | --schedule: expected predict, paper, shooting, gathering or matrix, got PAPER
            --schedule             | --schedule: expected predict, paper, shooting, gathering or matrix, got nothing
            --form-factors x a b   | --form-factors: expected raycast, plain, hemicube or nusselt, got x
            --form-factors         | --form-factors: expected raycast, plain, hemicube or nusselt, got nothing
            --emission x a b       | --emission: expected luminosity or specular, got x
            --lights x a b         | --lights: expected auto, ignore or emitters, got x
            --frame x a b          | --frame: expected a number, got x
            --frame NaN a b        | --frame: expected a number, got NaN
            --map x a b            | --map: expected <prefix=dir>, got x
            --content              | --content: expected <dir>, got nothing
            --size 640 a b         | --size: expected a size such as 640x480, each at most 16384, got 640
            --size 64x48 a b       | --size: expected with --picture, --false-colour or -sn, got it without
            --final-gather 9 a b   | --final-gather: expected with --picture or -sn, got it without
            --final-gather 0 a b   | --final-gather: expected a whole number from 1 to 1000000, got 0
            --final-gather 1e3 a b | --final-gather: expected a whole number from 1 to 1000000, got 1e3
            --size 0x480 a b       | --size: expected a size such as 640x480, each at most 16384, got 0x480
            --size 640x480x3 a b   | --size: expected a size such as 640x480, each at most 16384, got 640x480x3
            --size 640x99999 a b   | --size: expected a size such as 640x480, each at most 16384, got 640x99999
            --exposure 101 a b     | --exposure: expected a number from -100 to 100, got 101
            --exposure NaN a b     | --exposure: expected a number from -100 to 100, got NaN
            --tone-mapping x a b   | --tone-mapping: expected linear, reinhard or filmic, got x
            --picture x.bmp a b    | --picture: expected a name that ends in .png, .jpg or .hdr, got x.bmp
            --picture              | --picture: expected <file>, got nothing
            --points x             | --points: expected a table of points to read and one to write, got x
            --points x a.lws b     | --points: expected a table of points to read and one to write, got x a.lws
            --points x -q a b      | --points: expected a table of points to read and one to write, got x before -q
            --report a.lws b       | --report: expected a file to write, such as a.json, got a.lws
            --frames a b           | --frames: expected frames like 0-100 or 0-100:2, got a
            --frames 5-1 a.lws b   | --frames: expected frames like 0-100 or 0-100:2, got 5-1
            --frames 0-2:0 a.lws b | --frames: expected frames like 0-100 or 0-100:2, got 0-2:0
            --frames               | --frames: expected frames like 0-100 or 0-100:2, got nothing
            --frames 0-2 a.glb b   | --frames: expected a LightWave scene (.lws), got a.glb
            --frames 0-2 --frame 3 a.lws b | --frames: expected without --frame, got both
            --frames 0-2 -dr a.lws b | --frames: expected without -dr, got both
            --frmes 0-2 a.lws b    | --frmes: expected an option that --help lists, got an unknown one; did you mean --frames or --frame?
            --sky blue a b         | --sky: expected cie-overcast, cie-clear or uniform, each with =lx or without, got blue
            --sky uniform=0 a b    | --sky: expected cie-overcast, cie-clear or uniform, each with =lx or without, got uniform=0
            --sky uniform=x a b    | --sky: expected cie-overcast, cie-clear or uniform, each with =lx or without, got uniform=x
            --sky                  | --sky: expected cie-overcast, cie-clear or uniform, each with =lx or without, got nothing
            --sky uniform --sky uniform a b | --sky: expected once, got twice
            --sun 1,1 1000 a b     | --sun: expected a direction x,y,z and an illuminance in lx, like 1,2,1 50000, got 1,1 1000
            --sun 0,0,0 1000 a b   | --sun: expected a direction x,y,z and an illuminance in lx, like 1,2,1 50000, got 0,0,0 1000
            --sun 1,1,0 -5 a b     | --sun: expected a direction x,y,z and an illuminance in lx, like 1,2,1 50000, got 1,1,0 -5
            --sun 1,1,0 a.lws b    | --sun: expected a direction x,y,z and an illuminance in lx, like 1,2,1 50000, got 1,1,0 a.lws
            --sun 1,1,0            | --sun: expected a direction x,y,z and an illuminance in lx, like 1,2,1 50000, got 1,1,0
            --sun --sky cie-clear a b | --sun: expected a direction x,y,z and an illuminance in lx, like 1,2,1 50000, got nothing before --sky
            --sun 1,1,0 --sky=uniform a b | --sun: expected a direction x,y,z and an illuminance in lx, like 1,2,1 50000, got 1,1,0 before --sky=uniform
            --sun 1,1,0 -q a b     | --sun: expected a direction x,y,z and an illuminance in lx, like 1,2,1 50000, got 1,1,0 before -q
            --sun 0 0 --sky uniform a b | --sun: expected a direction x,y,z and an illuminance in lx, like 1,2,1 50000, got 0 0
            --sun                  | --sun: expected a direction x,y,z and an illuminance in lx, like 1,2,1 50000, got nothing
            --grid --spacing 1 a b | --grid: expected a surface or plane and a table to write, got nothing before --spacing
            --grid floor --spacing 1 a b | --grid: expected a surface or plane and a table to write, got floor before --spacing
            --grid -y=1 -q a b     | --grid: expected a surface or plane and a table to write, got -y=1 before -q
            --grid                 | --grid: expected a surface or plane and a table to write, got nothing
            --points --grid floor a b | --points: expected a table of points to read and one to write, got nothing before --grid
            -tf --sky uniform a b  | -tf: expected a scene file, got nothing before --sky
            -tf -q a b             | -tf: expected a scene file, got nothing before -q
            -h -q a b              | -h: expected the number of hosts and their names, as in -h 3 andreas daniel igge (see --help), got nothing before -q
            -h 1 --sky a b         | -h: expected the names of 1 host, got 0 before --sky
            --luminaire --sky uniform a b | --luminaire: expected <name=file>, got nothing before --sky
            --map --sky uniform a b | --map: expected <prefix=dir>, got nothing
            --sun 1,1,0 9 --sun 1,1,0 9 a b | --sun: expected once, got twice
            --lightmap             | --lightmap: expected <file.glb>, got nothing
            --lightmap o.png a b   | --lightmap: expected a name that ends in .glb, got o.png
            --lightmap-texels 0 --lightmap o.glb a b | --lightmap-texels: expected a number above 0, got 0
            --lightmap-texels      | --lightmap-texels: expected a number above 0, got nothing
            --lightmap-texels 5 a b | --lightmap-texels: expected with --lightmap, got it without
            --lihgtmap o.glb a b   | --lihgtmap: expected an option that --help lists, got an unknown one; did you mean --lightmap?
            --change               | --change: expected <old.scene>, got nothing
            --change o a.lws       | files: expected a scene to read and a scene file to write, got a.lws
            --change o -tf o a b   | --change: expected without -tf, got both
            --chnage o a b         | --chnage: expected an option that --help lists, got an unknown one; did you mean --change?
            --layers=3 a b         | --layers: expected no value, got 3
            --layers --layers a b  | --layers: expected once, got twice
            --layer a b            | --layer: expected an option that --help lists, got an unknown one; did you mean --layers?
            --srgb=1 a b           | --srgb: expected no value, got 1
            --sgrb a b             | --sgrb: expected an option that --help lists, got an unknown one; did you mean --srgb?
            --photometric=yes a b  | --photometric: expected no value, got yes
            --photometrc a b       | --photometrc: expected an option that --help lists, got an unknown one; did you mean --photometric?
            --strict=1 a b         | --strict: expected no value, got 1
            --strikt a b           | --strikt: expected an option that --help lists, got an unknown one; did you mean --strict?
            --statistics=1 a b     | --statistics: expected no value, got 1
            --statistics a b       | --statistics: expected with -h, got it without
            --statistic a b        | --statistic: expected an option that --help lists, got an unknown one; did you mean --statistics?
            --unit                 | --unit: expected mm, cm, m, in or ft, got nothing
            --luminaire            | --luminaire: expected <name=file>, got nothing
            --luminaire =f a b     | --luminaire: expected <name=file>, got =f
            --luminaire L= a b     | --luminaire: expected <name=file>, got L=
            --luminaire L=f --luminaire L=g a b | --luminaire: expected every name once, got L twice
            -x a b                 | -x: expected an option that --help lists, got an unknown one
            --acuracy 2% a b       | --acuracy: expected an option that --help lists, got an unknown one; did you mean --accuracy?
            -accuracy 2% a b       | -accuracy: expected an option that --help lists, got an unknown one; did you mean --accuracy?
            --pciture=x a b        | --pciture=x: expected an option that --help lists, got an unknown one; did you mean --picture?
            -paq a b               | -paq: expected an option that --help lists, got an unknown one; did you mean -pa?
            --patch 3 a b          | --patch: expected an option that --help lists, got an unknown one; did you mean --patch-area?
            -q                     | files: expected a scene to read and a scene file to write, got none
            a                      | files: expected a scene to read and a scene file to write, got a
            a out.png              | out.png: expected a scene file to write, such as a.scene, got the name of a picture; --picture out.png writes one besides
            a.scene b.lws          | b.lws: expected a scene file to write, such as a.scene, got the name of another kind of file; the scene to read comes first
            a b.gltf               | b.gltf: expected a scene file to write, such as a.scene, got the name of another kind of file; the scene to read comes first
            a b c                  | files: expected a scene to read and a scene file to write, got a b c
            """)
    void wrongCommandLine_isToldInOneLine(String commandLine, String expected) {
        Failure failure = assertThrows(Failure.class, () -> parse(commandLine));
        assertEquals(expected, failure.getMessage());
        assertEquals(ExitCode.COMMAND_LINE, failure.exitCode());
    }

    /** A null character here; on Windows a question mark, too. */
    @ParameterizedTest
    @ValueSource(strings = {"-tf a\0b 10 a b", "--points a\0b c a b", "--points a b\0c a b"})
    void pathsThatTheSystemDoesNotTake_areToldInOneLine(String commandLine) {
        String told = assertThrows(Failure.class, () -> parse(commandLine)).getMessage();
        assertTrue(told.matches("(-tf|--points): expected a path, got .*"), told);
    }

    @Test
    void emptyName_isNoFile() {
        RendererOptions options = new RendererOptions();
        Failure failure = assertThrows(Failure.class, () -> {
            new CommandLineParser(options).parse("", "b");
            options.check();
        });
        assertEquals("files: expected a scene to read and a scene file to write, got \"\" b", failure.getMessage());
    }

    @Test
    void emptyValue_isNothing() {
        RendererOptions options = new RendererOptions();
        Failure failure = assertThrows(Failure.class, () -> new CommandLineParser(options).parse("-pa", "", "a", "b"));
        assertEquals("-pa: expected a number above 0, got nothing", failure.getMessage());
    }

    @ParameterizedTest
    @ValueSource(strings = {"--statistics a b", "-key k a b"})
    void whatNeedsHosts_isRefusedWithout(String commandLine) {
        Failure failure = assertThrows(Failure.class, () -> parse(commandLine));
        assertTrue(failure.getMessage().endsWith("expected with -h, got it without"), failure.getMessage());
        assertEquals(ExitCode.COMMAND_LINE, failure.exitCode());
    }

    @Test
    void everyOption_hasALongName() {
        for (OptionSpec option : new CommandLine(new RendererOptions()).getCommandSpec().options()) {
            assertTrue(option.longestName().startsWith("--"), option.longestName());
        }
    }

    @Test
    void everyOption_standsOnceInTheHelp() {
        String help = new CommandLineParser(new RendererOptions()).help();
        for (OptionSpec option : new CommandLine(new RendererOptions()).getCommandSpec().options()) {
            String names = "  " + String.join(", ", option.names());
            assertEquals(2, help.split("(?m)^" + names + "(?![\\w-])", -1).length, names);
        }
    }

    @Test
    void help_hasNoPatternsLeft() {
        for (Object options : List.of(new RendererOptions(), new ServerOptions(), new ViewOptions())) {
            String help = new CommandLineParser(options).help();
            assertFalse(help.contains("%%") || help.contains("%n"), help);
        }
    }

    @ParameterizedTest
    @CsvSource({"-q, PREDICT", "-it 5, PAPER", "-se .1, PAPER", "--schedule predict -it 5, PREDICT",
        "--schedule paper, PAPER"})
    void schedule_isThePapersWhereItsStopRulesAreGiven(String options, Schedule expected) {
        CalculationOptions calculation = parse(options + " a b").calculation;
        assertEquals(expected, calculation.settings(null, calculation.defaults()).schedule());
    }

    @Test
    void accuracy_setsRaysAndMesh() {
        CalculationOptions calculation = parse("--accuracy 1% a b").calculation;
        assertEquals(RadiositySettings.defaults().accurate(0.01), calculation.settings(null, calculation.defaults()));
    }

    @ParameterizedTest
    @CsvSource({"--accuracy 1% --schedule paper, --accuracy", "--time 1s --schedule paper, --time"})
    void accuracyAndTime_areForPredictionOnly(String commandLine, String option) {
        assertEquals(option + ": expected --schedule predict, got paper",
                assertThrows(Failure.class, () -> parse(commandLine + " a b")).getMessage());
    }

    @ParameterizedTest
    @CsvSource({"--time 1s -it 3, -it, --time", "--accuracy 1% -se .1, -se, --accuracy"})
    void stopRuleOfThePapersSchedule_isNamedWhereAccuracyOrTimeNeedsPrediction(String commandLine, String culprit,
            String with) {
        assertEquals(culprit + ": expected --schedule predict with " + with + ", got no --schedule",
                assertThrows(Failure.class, () -> parse(commandLine + " a b")).getMessage());
    }

    /** What emits in a glTF is then in cd/m², as with luminaires. */
    @Test
    void sunAndSky_makeTheSceneThatIsReadPhotometric() {
        assertTrue(parse("--sun 0,1,0 1000 a b").readOptions().units().isPhotometric());
        assertTrue(parse("--sky uniform a b").readOptions().units().isPhotometric());
        assertFalse(parse("a b").readOptions().units().isPhotometric());
    }

    @Test
    void withoutOptions_everythingIsDefault() {
        RendererOptions options = parse("a b");
        assertEquals(RadiositySettings.defaults(), options.calculation.settings(null, options.calculation.defaults()));
        assertEquals(Integer.MAX_VALUE, options.calculation.stopRule().shots());
        assertEquals(Path.of("a"), options.input());
        assertEquals(Path.of("b"), options.output());
    }

    @Test
    void repeatableOptions_keepTheirOrder() {
        RendererOptions options = parse("--picture 1.png --picture 2.JPG --content src --content docs --map D:/x=scripts a b");
        assertEquals(List.of(Path.of("1.png"), Path.of("2.JPG")), options.picture.pictures);
        assertEquals(List.of(Path.of("src"), Path.of("docs")), options.scene.content);
        assertEquals(Path.of("scripts"), options.scene.map.get("D:/x"));
    }

    @Test
    void optionsMayFollowFiles() {
        assertEquals(5, parse("a b -nr 5").calculation.rays);
    }
}
