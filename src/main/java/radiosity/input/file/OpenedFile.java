package radiosity.input.file;

import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;
import radiosity.settings.ReadOptions;

/**
 * The file of a scene with everything that its reader needs.
 *
 * @param bytes  the whole file; not copied
 * @param name   of the file without directories, for messages
 * @param search finds the files that the scene names
 * @param notes  collects remarks about things that are left out or repaired
 */
public record OpenedFile(byte[] bytes, String name, FileSearch search, Diagnostics notes) {

    /**
     * Reads a file.
     *
     * @param warnings receives the lines of the notes
     * @throws IOException where the file cannot be read, or is larger than the options allow
     */
    public static OpenedFile of(Path file, ReadOptions options, Consumer<String> warnings) throws IOException {
        String name = String.valueOf(file.getFileName());
        byte[] bytes = InputFile.read(file, name, options.maxBytes());
        Diagnostics notes = new Diagnostics(name, warnings, options.strict());
        FileSearch search = new FileSearch(file, options.content(), options.map(), start -> false, notes);
        return new OpenedFile(bytes, name, search, notes);
    }
}
