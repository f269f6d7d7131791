package org.robotui.core.internal.config;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.bridge.BridgeEnd;
import org.robotui.api.bridge.BridgeWords;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Settings;
import org.robotui.api.host.Problem;
import org.robotui.api.port.SourceId;

/** Reads bridges: names with a section each, whose ends are ports of robot interfaces of the same file. */
final class BridgesReader {
  private static final List<String> OF_CALLS = List.of("reply", "feedback");
  private static final List<String> NOT_OF_CALLS =
      List.of("transform", "when", "rate", "keep", "latched", "max_linear", "max_angular");

  private static final List<String> NOT_OF_PARAMETERS = Stream.concat(NOT_OF_CALLS.stream(),
      Stream.of("type", "fields", "reply", "feedback", "timeout", "frames", "frame_prefix", "lease")).toList();

  private final Path file;
  private final Map<String, List<String>> interfaces;
  private final List<Problem> problems;
  private final Map<String, BridgeLoops> loops = new HashMap<>();

  /** For a file with these RUICs, each with the ids of its robot interfaces. */
  BridgesReader(Path file, Map<String, List<String>> interfaces, List<Problem> problems) {
    this.file = file;
    this.interfaces = interfaces;
    this.problems = problems;
  }

  /** The robot interfaces of a file, also those that have errors. */
  static Map<String, List<String>> interfaces(YamlValue.Section root) {
    Map<String, List<String>> found = new LinkedHashMap<>();
    root.get("ruics").filter(YamlValue.Section.class::isInstance).map(YamlValue.Section.class::cast)
        .ifPresent(ruics -> ruics.entries().forEach(ruic -> found.put(ruic.key(), ids(ruic.value()))));
    return found;
  }

  private static List<String> ids(YamlValue ruic) {
    return ruic instanceof YamlValue.Section section
        ? section.get("rfics").filter(YamlValue.Section.class::isInstance).map(YamlValue.Section.class::cast)
            .map(rfics -> rfics.entries().stream().map(YamlValue.Entry::key).toList()).orElse(List.of())
        : List.of();
  }

  List<BridgeConfig> read(YamlValue value) {
    List<BridgeConfig> bridges = new ArrayList<>();
    Shape.section(value, "'bridges'", problems)
        .ifPresent(section -> section.entries().forEach(entry -> bridge(entry).ifPresent(bridges::add)));
    return List.copyOf(bridges);
  }

  private Optional<BridgeConfig> bridge(YamlValue.Entry entry) {
    Optional<YamlValue.Section> section = Shape.section(entry.value(), "the bridge '" + entry.key() + "'", problems);
    if (section.isEmpty()) {
      return Optional.empty();
    }
    int before = problems.size();
    Settings settings = new ValueReader(problems).settings(section.get(), BridgeWords.SCHEMA);
    if (problems.size() > before) {
      return Optional.empty();
    }
    Optional<BridgeEnd> from = end(settings.placed("from"));
    Optional<BridgeEnd> to = end(settings.placed("to"));
    if (from.isEmpty() || to.isEmpty()) {
      return Optional.empty();
    }
    BridgeConfig bridge =
        new BridgeConfig(file, entry.place().line(), entry.key(), from.get(), to.get(), settings);
    Optional<String> fault = fault(settings)
        .or(() -> BridgeFilters.fault(bridge))
        .or(() -> loops.computeIfAbsent(namesOf(settings.text("kind")), names -> new BridgeLoops()).add(bridge));
    fault.ifPresent(f -> problems.add(entry.place().error("the bridge '" + entry.key() + "' " + f)));
    return fault.isEmpty() ? Optional.of(bridge) : Optional.empty();
  }

  private static Optional<String> fault(Settings settings) {
    String kind = settings.text("kind");
    return switch (kind) {
      case BridgeWords.VALUES -> faultOfValues(settings);
      case BridgeWords.PARAMETER -> NOT_OF_PARAMETERS.stream().filter(settings::has).findFirst()
          .map(word -> "keeps a parameter equal, and '" + word + "' does not go with it; leave it out");
      default -> faultOfCalls(settings, kind);
    };
  }

  /** Topics, services and parameters have names of their own; services and actions answer each other. */
  private static String namesOf(String kind) {
    return kind.equals(BridgeWords.ACTION) ? BridgeWords.SERVICE : kind;
  }

  private static Optional<String> faultOfCalls(Settings settings, String kind) {
    String offers = "offers " + (kind.equals(BridgeWords.ACTION) ? "an action" : "a service");
    if (settings.flag("both")) {
      return Optional.of(offers + ", which goes one way; leave out 'both', and write a bridge for each " + kind);
    }
    if (kind.equals(BridgeWords.SERVICE) && settings.has("feedback")) {
      return Optional.of(offers + ", and 'feedback' is for actions; leave it out, or write 'kind: action'");
    }
    return NOT_OF_CALLS.stream().filter(settings::has).findFirst()
        .map(word -> offers + ", and '" + word + "' is for values; leave it out, or 'kind: " + kind + "'");
  }

  private static Optional<String> faultOfValues(Settings settings) {
    Optional<String> foreign = OF_CALLS.stream().filter(settings::has).findFirst();
    if (foreign.isPresent()) {
      return Optional.of("carries values, and '" + foreign.get() + "' is for services and actions; leave it out, or"
          + " write 'kind: service' or 'kind: action'");
    }
    if (settings.flag("both") && settings.has("fields")) {
      return Optional.of("goes both ways, but its 'fields' go one way only; write a bridge for each way, or use a"
          + " 'transform', which knows both");
    }
    return settings.has("fields") && settings.has("transform")
        ? Optional.of("has both 'fields' and a 'transform'; leave one of them out")
        : Optional.empty();
  }

  /** The name of a RUIC may have dots in it: the longest one that fits is meant. */
  private Optional<BridgeEnd> end(Placed written) {
    String text = written.value().toString();
    Optional<String> ruic = interfaces.keySet().stream().filter(name -> text.startsWith(name + "."))
        .max(Comparator.comparingInt(String::length));
    if (ruic.isEmpty()) {
      String first = text.substring(0, text.indexOf('.'));
      return wrong(written, "there is no robot UI '" + first + "' for a bridge"
          + NearestWord.hint(first, interfaces.keySet()));
    }
    String rest = text.substring(ruic.get().length() + 1);
    List<String> ids = interfaces.get(ruic.get());
    Optional<String> named = ids.stream().filter(id -> rest.startsWith(id + ".") && rest.length() > id.length() + 1)
        .max(Comparator.comparingInt(String::length));
    if (named.isEmpty() && ids.size() != 1) {
      return wrong(written, "'" + ruic.get() + "' has " + (ids.isEmpty() ? "no robot interface"
          : "several robot"
              + " interfaces; write which of them is meant, such as " + ruic.get() + "." + ids.getFirst() + "."
              + rest));
    }
    String port = named.map(id -> rest.substring(id.length() + 1)).orElse(rest);
    return Optional.of(new BridgeEnd(ruic.get(),
        new SourceId(named.orElseGet(ids::getFirst), port.startsWith("/") ? port.substring(1) : port)));
  }

  private Optional<BridgeEnd> wrong(Placed written, String message) {
    problems.add(Place.of(written, "").error(message));
    return Optional.empty();
  }
}
