package radiosity.cli;

import java.util.List;
import java.util.Map;
import picocli.CommandLine;
import picocli.CommandLine.Help;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Help.TextTable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/** What {@code --help} prints: options in groups, one for each mixin of a command, headed by its name. */
final class HelpText {

    /** Columns for an option's names, and for what it does. */
    private static final int[] WIDTHS = {40, 60};

    private HelpText() { }

    static String of(CommandLine commandLine) {
        commandLine.getHelpSectionMap().put(UsageMessageSpec.SECTION_KEY_OPTION_LIST, HelpText::groups);
        return commandLine.getUsageMessage(Ansi.OFF);
    }

    private static String groups(Help help) {
        StringBuilder text = new StringBuilder();
        CommandSpec command = help.commandSpec();
        for (Map.Entry<String, CommandSpec> mixin : command.mixins().entrySet()) {
            append(text, mixin.getKey(), mixin.getValue().options());
        }
        append(text, "Besides", command.options().stream().filter(option -> !mixed(command, option)).toList());
        return text.toString();
    }

    private static boolean mixed(CommandSpec command, OptionSpec option) {
        return command.mixins().values().stream().anyMatch(m -> m.findOption(option.longestName()) != null);
    }

    private static void append(StringBuilder text, String title, List<OptionSpec> options) {
        TextTable table = TextTable.forColumnWidths(Help.defaultColorScheme(Ansi.OFF), WIDTHS);
        table.indentWrappedLines = 0;
        for (OptionSpec option : options) {
            table.addRowValues(names(option), String.join(" ", option.description()));
        }
        text.append(title).append(":%n".formatted()).append(table).append("%n".formatted());
    }

    private static String names(OptionSpec option) {
        String names = "  " + String.join(", ", option.names());
        return option.arity().max() == 0 ? names : names + " " + option.paramLabel();
    }
}
