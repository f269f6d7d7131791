package org.robotui.headless.internal;

import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.input.Numerals;
import org.robotui.api.port.Port;

/** Writes the words of configurations, for people or as a JSON line per setting. */
final class WordsPrinter {
  /** How deep groups within groups are followed. */
  private static final int DEEPEST = 6;

  private final PrintStream out;
  private final boolean json;

  WordsPrinter(PrintStream out, boolean json) {
    this.out = out;
    this.json = json;
  }

  /**
   * What can be configured.
   *
   * @param kind in words, such as view
   * @param id the word of its type
   * @param label what users read
   * @param help what it is for
   * @param schema its settings
   * @param ports those that it always has
   */
  record Described(String kind, String id, String label, String help, Schema schema, List<Port> ports) {}

  /** A line for each. */
  void list(List<Described> all) {
    int width = all.stream().mapToInt(d -> d.id().length()).max().orElse(1);
    String kind = "";
    for (Described each : all) {
      if (json) {
        out.println(new Json().put("kind", each.kind()).put("type", each.id()).put("label", each.label())
            .put("help", each.help()).end());
        continue;
      }
      if (!each.kind().equals(kind)) {
        out.println((kind.isEmpty() ? "" : "\n") + each.kind());
        kind = each.kind();
      }
      out.println("  " + padded(each.id(), width) + "  " + each.help());
    }
  }

  /** All of one. */
  void print(Described it) {
    if (!json) {
      out.println(it.id() + " (" + it.kind() + "): " + it.help());
      it.ports().forEach(port -> out.println("  port " + port.name() + ": " + port.typeName()
          + (port.help().isEmpty() ? "" : ". " + port.help())));
    }
    settings(it, it.schema(), "", 1);
    if (!json) {
      out.println();
    }
  }

  private void settings(Described of, Schema schema, String within, int depth) {
    for (Setting setting : schema.settings()) {
      String path = within + setting.name();
      if (json) {
        out.println(line(of, setting, path));
      } else {
        String indent = "  ".repeat(depth);
        out.println(indent + setting.name() + usual(setting));
        out.println(indent + "    " + upper(setting.type().expected()) + ". " + upper(setting.help()));
      }
      group(setting.type()).filter(s -> depth < DEEPEST).ifPresent(inner -> settings(of, inner, path + ".", depth + 1));
    }
  }

  private static String line(Described of, Setting setting, String path) {
    Json line = new Json().put("kind", of.kind()).put("type", of.id()).put("setting", path)
        .put("expected", setting.type().expected()).put("help", setting.help())
        .put("needed", setting.required() ? "yes" : "no");
    setting.fallback().ifPresent(value -> line.put("usual", text(value)));
    return line.end();
  }

  private static String usual(Setting setting) {
    return setting.required() ? " (must be written)" : setting.fallback().map(value -> ": " + text(value)).orElse("");
  }

  /** As it would be written. */
  private static String text(Object value) {
    return switch (value) {
      case Placed placed -> text(placed.value());
      case Double number -> Numerals.text(number);
      case String word -> word.isEmpty() ? "\"\"" : word;
      case List<?> list -> "[" + String.join(", ", list.stream().map(WordsPrinter::text).toList()) + "]";
      case Map<?, ?> map -> "{" + String.join(", ",
          map.entrySet().stream().map(e -> e.getKey() + ": " + text(e.getValue())).toList()) + "}";
      case Settings settings -> text(settings.values());
      default -> value.toString();
    };
  }

  /** The group that a value is or holds. */
  private static Optional<Schema> group(ValueType type) {
    return switch (type) {
      case ValueType.Section section -> Optional.of(section.schema());
      case ValueType.ListOf list -> group(list.element());
      case ValueType.MapOf map -> group(map.value());
      case ValueType.Dependent dependent -> group(dependent.otherwise());
      case ValueType.WithPlace placed -> group(placed.value());
      case ValueType.AnyOf any -> any.alternatives().stream().map(WordsPrinter::group).flatMap(Optional::stream)
          .findFirst();
      case ValueType.Text t -> Optional.empty();
      case ValueType.Flag f -> Optional.empty();
      case ValueType.Num n -> Optional.empty();
      case ValueType.Int i -> Optional.empty();
      case ValueType.Choice c -> Optional.empty();
    };
  }

  private static String upper(String sentence) {
    return sentence.isEmpty() ? "" : sentence.substring(0, 1).toUpperCase(Locale.ROOT) + sentence.substring(1);
  }

  private static String padded(String text, int width) {
    return text + " ".repeat(Math.max(0, width - text.length()));
  }
}
