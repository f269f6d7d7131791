package org.robotui.core.internal.config;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.robotui.api.host.Problem;
import org.robotui.api.host.WindowConfig;

/** Reads which windows are opened: names of RUICs, or {@code {show: name, weight: 2}}, side by side in their order. */
final class WindowsReader {
  private static final List<String> KEYS = List.of("show", "weight");
  private static final int MOST = 16;

  private final Path file;
  private final List<String> ruics;
  private final List<Problem> problems;
  private final Set<String> shown = new HashSet<>();

  /** For a file with RUICs of these names. */
  WindowsReader(Path file, List<String> ruics, List<Problem> problems) {
    this.file = file;
    this.ruics = ruics;
    this.problems = problems;
  }

  List<WindowConfig> read(YamlValue value) {
    List<YamlValue> items = Shape.items(value);
    if (items.size() > MOST) {
      problems.add(value.place().error("'windows' has " + items.size() + " windows; write at most " + MOST));
      return List.of();
    }
    List<WindowConfig> windows = new ArrayList<>();
    items.forEach(item -> window(item).ifPresent(windows::add));
    return List.copyOf(windows);
  }

  private Optional<WindowConfig> window(YamlValue item) {
    return switch (item) {
      case YamlValue.Scalar s -> ruic(s).map(name -> new WindowConfig(file, name, 1));
      case YamlValue.Section s -> section(s);
      case YamlValue.Items i -> {
        problems
            .add(i.place().error("a window shows one RUIC: write its name, or {show: name, weight: 2}, not a list"));
        yield Optional.empty();
      }
    };
  }

  private Optional<WindowConfig> section(YamlValue.Section section) {
    Shape.onlyKeys(section, KEYS, "in a window", problems);
    double weight = section.get("weight").flatMap(w -> Shape.weight(w, problems)).orElse(1.0);
    return Shape.required(section, "show", "the name of a RUIC, such as {show: " + example() + ", weight: 2}", problems)
        .flatMap(this::ruic).map(name -> new WindowConfig(file, name, weight));
  }

  private String example() {
    return ruics.stream().findFirst().orElse("Natalie");
  }

  private Optional<String> ruic(YamlValue value) {
    Optional<String> name = Shape.text(value, "a window", "the name of a RUIC, such as " + example(), problems);
    name.filter(n -> !ruics.contains(n)).ifPresent(n -> problems
        .add(value.place().error("there is no RUIC '" + n + "' for a window" + NearestWord.hint(n, ruics))));
    Optional<String> known = name.filter(ruics::contains);
    known.filter(n -> !shown.add(n)).ifPresent(
        n -> problems.add(value.place().error("'" + n + "' has a window already; a RUIC is shown in one at a time")));
    return known;
  }
}
