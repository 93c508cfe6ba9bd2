package radiosity.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * What users do wrong with files and programs: one line each that names the option or the file and says what is
 * expected instead, and nothing is written. Wrong values are in {@link CommandLineTest}.
 */
class WrongUsesTest {

    private static final List<String> PROGRAMS = List.of("RadiosityRenderer", "ViewSceneFile", "PartitionServer");

    @TempDir
    static Path folder;

    @BeforeAll
    static void makeFiles() throws IOException {
        Files.copy(Path.of("scenes/cornell-box.lws"), folder.resolve("a.lws"));
        Files.copy(Path.of("scenes/cornell-box.lwo"), folder.resolve("cornell-box.lwo"));
        ViewSceneFile.run("--version"); // loads what it needs before its errors are compared
        assertEquals(0, RadiosityRenderer.run("-q", "-dr", folder + "/a.lws", folder + "/lit.scene"));
        Files.writeString(folder.resolve("b.fbx"), "Kaydara FBX Binary  \0");
        Files.writeString(folder.resolve("c.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Files.writeString(folder.resolve("poem.txt"), "A poem of more than twenty bytes");
        Files.copy(Path.of("src/test/resources/radiosity/input/room.glb"), folder.resolve("room.glb"));
        Files.writeString(folder.resolve("lamp.ies"), "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 2 1 1 2 0 0 0\n1 1 30\n"
                + "0 90\n0\n100 100\n");
        Files.writeString(folder.resolve("points.csv"), "0,0,0,0,1,0\n");
        Files.write(folder.resolve("empty.lws"), new byte[0]);
        Files.writeString(folder.resolve("d.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", StandardCharsets.UTF_16);
        Files.writeString(folder.resolve("wide.ies"), "IESNA:LM-63-2002\n", StandardCharsets.UTF_16);
    }

    private static int run(List<String> words) {
        String[] rest = words.subList(1, words.size()).toArray(String[]::new);
        return switch (PROGRAMS.indexOf(words.get(0))) {
            case 0 -> RadiosityRenderer.run(rest);
            case 1 -> ViewSceneFile.run(rest);
            default -> PartitionServer.run(rest);
        };
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            RadiosityRenderer @/none.lws @/o.scene                 | 3 | @/none.lws: expected a readable file, got none
            RadiosityRenderer @ @/o.scene                          | 3 | @: expected a file, got a directory
            RadiosityRenderer @/a.lws @                            | 3 | @: expected a file that can be written, got a directory
            RadiosityRenderer @/a.lws @/no/o.scene                 | 3 | @/no/o.scene: expected a directory that can be written, got none
            RadiosityRenderer @/a.lws @/a.lws                      | 2 | @/a.lws: expected a scene file to write, such as a.scene, got the name of another kind of file; the scene to read comes first
            RadiosityRenderer @/o.scene @/a.lws                    | 2 | @/a.lws: expected a scene file to write, such as a.scene, got the name of another kind of file; the scene to read comes first
            RadiosityRenderer @/b.fbx @/o.scene                    | 3 | b.fbx: expected a scene, got an FBX file; LightWave, glTF and OBJ are read
            RadiosityRenderer @/poem.txt @/o.scene                 | 3 | poem.txt: expected a scene, got a file that begins with "A poem of mo"; LightWave, glTF and OBJ are read
            RadiosityRenderer @/d.obj @/o.scene                    | 3 | d.obj: expected a scene, got text in UTF-16; LightWave scenes, glTF and OBJ are in UTF-8 or ASCII
            RadiosityRenderer --unit mm --luminaire 1,1,1=@/wide.ies @/a.lws @/o.scene | 3 | @/wide.ies: expected an IES or EULUMDAT file, got text in UTF-16
            RadiosityRenderer @/empty.lws @/o.scene                | 3 | empty.lws: expected a LightWave scene or object, got an empty file
            RadiosityRenderer @/lit.scene @/o.scene                | 3 | lit.scene: expected a scene without light, got a scene file of this program; give what it was made from
            RadiosityRenderer --content @/no @/a.lws @/o.scene     | 3 | --content: expected a directory, got @/no, which is not there
            RadiosityRenderer --content @/a.lws @/a.lws @/o.scene  | 3 | --content: expected a directory, got @/a.lws, a file
            RadiosityRenderer --map C:=@/no @/a.lws @/o.scene      | 3 | --map C:: expected a directory, got @/no, which is not there
            RadiosityRenderer --points @/points.csv @/a.lws @/o.scene | 2 | --points: expected a table of points to read and one to write, got @/points.csv @/a.lws
            RadiosityRenderer --points @/no.csv @/o.csv @/a.lws @/o.scene | 3 | @/no.csv: expected a readable file, got none
            RadiosityRenderer --picture @/a.lws @/o.scene          | 2 | --picture: expected a name that ends in .png, .jpg or .hdr, got @/a.lws
            RadiosityRenderer --picture @/o.png --report @/o.png @/a.lws @/o.scene | 2 | @/o.png: expected a file of its own for each output, got one twice
            RadiosityRenderer --report @/o.scene.journal @/a.lws @/o.scene | 2 | @/o.scene.journal: expected a file of its own for each output, got the journal of @/o.scene
            RadiosityRenderer --grid white @/g.csv @/a.lws @/o.scene | 2 | --grid: expected with --spacing, got it without
            RadiosityRenderer --spacing 5 @/a.lws @/o.scene        | 2 | --spacing: expected with --grid, got it without
            RadiosityRenderer --grid floor @/g.csv --spacing 50 @/a.lws @/o.scene | 2 | --grid: expected a surface of the scene (white, green, red, light) or a plane like y=0.85, got floor
            RadiosityRenderer --grid y=900 @/g.csv --spacing 50 @/a.lws @/o.scene | 2 | --grid: expected a plane from y=0.00000 to 548.800, got y=900
            RadiosityRenderer --grid white @/a.lws @/o.scene       | 2 | --grid: expected a surface or plane and a table to write, got white @/a.lws
            RadiosityRenderer --grid white @/g.csv --spacing 1e-3 @/a.lws @/o.scene | 2 | --grid: expected a spacing that gives at most 1000000 points, got 0.001
            RadiosityRenderer --false-colour @/o.jpg @/a.lws @/o.scene | 2 | --false-colour: expected a name that ends in .png, got @/o.jpg
            RadiosityRenderer --unit km @/a.lws @/o.scene          | 2 | --unit: expected mm, cm, m, in or ft, got km
            RadiosityRenderer --luminaire Lamp @/a.lws @/o.scene   | 2 | --luminaire: expected <name=file>, got Lamp
            RadiosityRenderer --luminaire Lamp=@/no.ies @/a.lws @/o.scene | 3 | @/no.ies: expected a readable file, got none
            RadiosityRenderer --luminaire 1,1,1=@/poem.txt @/a.lws @/o.scene | 3 | a.lws: expected a unit of length (--unit) for luminaires, whose intensity is in cd, got none
            RadiosityRenderer --unit mm --luminaire 1,1,1=@/poem.txt @/a.lws @/o.scene | 3 | @/poem.txt: expected an IES or EULUMDAT file, got a file that begins with "A poem of mo"
            RadiosityRenderer --unit mm --luminaire 1,1,1=@/a.lws @/a.lws @/o.scene | 3 | @/a.lws: expected an IES or EULUMDAT file, got a LightWave scene
            RadiosityRenderer --unit mm --luminaire 1,1,1=@/empty.lws @/a.lws @/o.scene | 3 | @/empty.lws: expected an IES or EULUMDAT file, got an empty file
            RadiosityRenderer --sky cie-clear @/a.lws @/o.scene    | 2 | --sky: expected cie-clear with --sun, above the horizon (y > 0), got no sun
            RadiosityRenderer --sky cie-clear --sun 0,-1,0 9 @/a.lws @/o.scene | 2 | --sun: expected a sun above the horizon (y is up), got one at 0,-1,0
            RadiosityRenderer --sky cie-clear --sun 1,0,0 9 @/a.lws @/o.scene | 2 | --sky: expected cie-clear with --sun, above the horizon (y > 0), got a sun on it
            RadiosityRenderer --sun --sky cie-clear @/a.lws @/o.scene | 2 | --sun: expected a direction x,y,z and an illuminance in lx, like 1,2,1 50000, got nothing before --sky
            RadiosityRenderer --sun 0 0 --sky cie-clear @/a.lws @/o.scene | 2 | --sun: expected a direction x,y,z and an illuminance in lx, like 1,2,1 50000, got 0 0
            RadiosityRenderer --strict --unit mm --luminaire 200,200,200000=@/lamp.ies @/a.lws @/o.scene | 3 | a.lws: expected luminaires in the scene or aimed at it, got 200,200,200000 at 200.000,200.000,200000, outside of 0.00000,0.00000,-559.200 to 556.000,548.800,0.00000; check unit and axes
            RadiosityRenderer --change @/no.scene @/a.lws @/o.scene | 3 | @/no.scene: expected a readable file, got none
            RadiosityRenderer --change @/a.lws @/a.lws @/o.scene   | 3 | @/a.lws: expected a scene file that RadiosityRenderer wrote, got a LightWave scene
            RadiosityRenderer --lightmap @/o.glb --lightmap-texels 1e9 @/a.lws @/o.scene | 2 | --lightmap-texels: expected at most 14.78 samples per unit for white, whose texture may have 8192 texels, got 1.0E9
            RadiosityRenderer --srgb --strict @/room.glb @/o.scene | 3 | room.glb: expected no warning (--strict), got --srgb is for LightWave and OBJ only; glTF says itself what is sRGB
            RadiosityRenderer --frame 3 --strict @/room.glb @/o.scene | 3 | room.glb: expected no warning (--strict), got a frame is chosen for LightWave only
            RadiosityRenderer --unit mm @/room.glb @/o.scene       | 2 | --unit: expected with LightWave or OBJ, got it with room.glb, which is in metres
            RadiosityRenderer --unit mm --luminaire Bulb=@/poem.txt @/a.lws @/o.scene | 3 | a.lws: expected a light that is called Bulb (--luminaire), or three coordinates x,y,z, got no lights
            RadiosityRenderer -tf @/a.lws @/a.lws @/o.scene        | 3 | @/a.lws: expected a scene file that RadiosityRenderer wrote, got a LightWave scene
            RadiosityRenderer -tf @/lit.scene 7 @/a.lws @/o.scene  | 2 | -tf: expected 0, with which @/lit.scene was saved, got 7
            RadiosityRenderer -tf @/lit.scene -pa 7 @/a.lws @/o.scene | 2 | -pa: expected none, with which @/lit.scene was made, got 7.0
            RadiosityRenderer -key @/no @/a.lws @/o.scene          | 2 | -key: expected with -h, got it without
            RadiosityRenderer --accuracy 1% -it 5 @/a.lws @/o.scene | 2 | -it: expected --schedule predict with --accuracy, got no --schedule
            RadiosityRenderer --info                               | 2 | --info: expected <file>, got nothing
            RadiosityRenderer --info @/a.lws                       | 3 | @/a.lws: expected a scene file that RadiosityRenderer wrote, got a LightWave scene
            RadiosityRenderer --info @/lit.scene @/o.scene         | 2 | --info: expected one scene file and nothing else, got @/o.scene, too
            RadiosityRenderer --info @/lit.scene -nr 5             | 2 | --info: expected alone, got -nr, too
            ViewSceneFile                                          | 2 | file: expected one scene file, got none
            ViewSceneFile @/lit.scene @/lit.scene                  | 2 | file: expected one scene file, got @/lit.scene @/lit.scene
            ViewSceneFile @/a.lws                                  | 3 | @/a.lws: expected a scene file that RadiosityRenderer wrote, got a LightWave scene
            ViewSceneFile @/cornell-box.lwo                        | 3 | @/cornell-box.lwo: expected a scene file that RadiosityRenderer wrote, got a LightWave object
            ViewSceneFile @/b.fbx                                  | 3 | @/b.fbx: expected a scene file that RadiosityRenderer wrote, got an FBX file
            ViewSceneFile @/c.obj                                  | 3 | @/c.obj: expected a scene file that RadiosityRenderer wrote, got an OBJ file
            ViewSceneFile --web @/poem.txt                         | 3 | @/poem.txt: expected a scene file that RadiosityRenderer wrote, got a file that begins with "A poem of mo"
            ViewSceneFile -lw @/b.fbx                              | 3 | b.fbx: expected a scene, got an FBX file; LightWave, glTF and OBJ are read
            ViewSceneFile -ut @/lit.scene                          | 3 | @/lit.scene: expected textures (RadiosityRenderer -ut <n>), got none
            ViewSceneFile --frame 3 @/lit.scene                    | 2 | --frame: expected with -lw, got it without
            ViewSceneFile --port 8081 @/lit.scene                  | 2 | --port: expected with --web, got it without
            ViewSceneFile --web --size 9x9 @/lit.scene             | 2 | --web: expected without -lw, -wf, -ut, --size and --screenshot, got one of them
            ViewSceneFile --screenshot @/o.jpg @/lit.scene         | 2 | --screenshot: expected a name that ends in .png, got @/o.jpg
            ViewSceneFile --sreenshot @/o.png @/lit.scene          | 2 | --sreenshot: expected an option that --help lists, got an unknown one; did you mean --screenshot?
            ViewSceneFile -wf=3 @/lit.scene                        | 2 | -wf: expected no value, got 3
            ViewSceneFile -fw @/lit.scene                          | 2 | -fw: expected an option that --help lists, got an unknown one; did you mean -wf or -lw?
            ViewSceneFile --source                                 | 2 | --source: expected <file>, got nothing
            ViewSceneFile --source @/no.lws @/lit.scene            | 3 | @/no.lws: expected a readable file, got none
            ViewSceneFile --source @/a.lws --web @/lit.scene       | 2 | --source: expected without -lw and --web, got one of them
            ViewSceneFile -lw --frames 0-3 @/a.lws                 | 2 | --frames: expected an option that --help lists, got an unknown one; did you mean --frame?
            ViewSceneFile -lw --sky uniform @/a.lws                | 2 | --sky: expected an option that --help lists, got an unknown one
            ViewSceneFile -lw --sun 0,1,0 9 @/a.lws                | 2 | --sun: expected an option that --help lists, got an unknown one
            PartitionServer --second-port                          | 2 | --second-port: expected a port from 1 to 65535, got nothing
            PartitionServer --second-port 0                        | 2 | --second-port: expected a port from 1 to 65535, got 0
            PartitionServer --second-prot 1098                     | 2 | --second-prot: expected an option that --help lists, got an unknown one; did you mean --second-port?
            PartitionServer -host                                  | 2 | -host: expected a host's name or address, got nothing
            PartitionServer -host a,b                              | 2 | -host: expected a host's name or address, got a,b
            PartitionServer -hots a                                | 2 | -hots: expected an option that --help lists, got an unknown one; did you mean -host?
            PartitionServer -bind                                  | 2 | -bind: expected <address>, got nothing
            PartitionServer -bind 192.0.2.1                        | 2 | -bind: expected an address of this machine, got 192.0.2.1
            PartitionServer -bidn 127.0.0.1                        | 2 | -bidn: expected an option that --help lists, got an unknown one; did you mean -bind?
            PartitionServer @/a.lws                                | 2 | @/a.lws: expected options that --help lists and no file, got one
            PartitionServer -port 99999                            | 2 | -port: expected a port from 1 to 65535, got 99999
            PartitionServer -prot 1099                             | 2 | -prot: expected an option that --help lists, got an unknown one; did you mean -port?
            PartitionServer -key @/no                              | 3 | @/no: expected a readable file, got none
            """)
    void wrongUse_isToldInOneLine(String commandLine, int exitCode, String expected) throws IOException {
        List<Path> before = files();
        PrintStream err = System.err;
        ByteArrayOutputStream told = new ByteArrayOutputStream();
        System.setErr(new PrintStream(told, true, StandardCharsets.UTF_8));
        int returned;
        try {
            returned = run(List.of(commandLine.replace("@", folder.toString()).split(" +")));
        } finally {
            System.setErr(err);
        }
        assertEquals(expected.replace("@", folder.toString()), told.toString(StandardCharsets.UTF_8).strip());
        assertEquals(exitCode, returned);
        assertEquals(before, files());
        assertFalse(told.toString(StandardCharsets.UTF_8).contains("\tat "));
    }

    private static List<Path> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.sorted().toList();
        }
    }
}
