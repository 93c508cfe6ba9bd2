package radiosity.input.file;

import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;
import radiosity.settings.ReadOptions;

/**
 * A scene's file as its reader finds it.
 *
 * @param bytes  the whole file; not copied
 * @param name   without directories, for messages
 * @param search for the files that it names
 * @param notes  takes one line for each kind of thing that is left out or mended
 */
public record OpenedFile(byte[] bytes, String name, FileSearch search, Diagnostics notes) {

    /**
     * Reads a file.
     *
     * @param warnings gets the lines of the notes
     * @throws IOException if the file cannot be read, or is larger than the options allow
     */
    public static OpenedFile of(Path file, ReadOptions options, Consumer<String> warnings) throws IOException {
        String name = String.valueOf(file.getFileName());
        byte[] bytes = InputFile.read(file, name, options.maxBytes());
        Diagnostics notes = new Diagnostics(name, warnings, options.strict());
        FileSearch search = new FileSearch(file, options.content(), options.map(), start -> false, notes);
        return new OpenedFile(bytes, name, search, notes);
    }
}
