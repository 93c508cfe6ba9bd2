package radiosity.cli.options;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import picocli.CommandLine;
import picocli.CommandLine.Help;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Help.TextTable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/** The text of {@code --help}: a group of options per mixin, headed by its name; then the command's other options. */
final class HelpText {

    /** Widths of the columns for the names and for the description of an option, characters. */
    private static final int[] WIDTHS = {40, 60};

    private HelpText() { }

    static String of(CommandLine commandLine) {
        commandLine.getHelpSectionMap().put(UsageMessageSpec.SECTION_KEY_OPTION_LIST, HelpText::groups);
        return commandLine.getUsageMessage(Ansi.OFF);
    }

    private static String groups(Help help) {
        StringBuilder text = new StringBuilder();
        CommandSpec command = help.commandSpec();
        Map<String, CommandSpec> groups = new LinkedHashMap<>(command.mixins());
        groups.remove(CommonOptions.GROUP);
        groups.forEach((title, mixin) -> append(text, title, mixin.options()));
        append(text, groups.isEmpty() ? "Parameters" : CommonOptions.GROUP, command.options().stream()
                .filter(option -> groups.values().stream().noneMatch(g -> g.findOption(option.longestName()) != null))
                .toList());
        return text.toString();
    }

    private static void append(StringBuilder text, String title, List<OptionSpec> options) {
        TextTable table = TextTable.forColumnWidths(Help.defaultColorScheme(Ansi.OFF), WIDTHS);
        table.indentWrappedLines = 0;
        for (OptionSpec option : options) {
            table.addRowValues(names(option), String.join(" ", option.description()));
        }
        text.append(title).append(":").append(System.lineSeparator()).append(table).append(System.lineSeparator());
    }

    private static String names(OptionSpec option) {
        String names = "  " + String.join(", ", option.names());
        return option.arity().max() == 0 ? names : names + " " + option.paramLabel();
    }
}
