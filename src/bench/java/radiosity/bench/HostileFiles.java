package radiosity.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import radiosity.input.lightwave.BulkFiles;
import radiosity.input.lightwave.HostileCase;
import radiosity.input.lightwave.HostileFilesTest;

/** Writes all hostile inputs of the tests out, for programs that read each of them by itself. */
public final class HostileFiles {

    private HostileFiles() {
    }

    /**
     * Prints a line for each input: the file to read, a tabulator, its name.
     *
     * @param args a folder to write into
     */
    public static void main(String[] args) throws IOException {
        int number = 0;
        for (HostileCase hostile : Stream.concat(HostileFilesTest.cases(), BulkFiles.all().stream()).toList()) {
            Path folder = Files.createDirectories(Path.of(args[0], "" + number));
            System.out.println(hostile.write(folder) + "\t" + hostile.name());
            number++;
        }
    }
}
