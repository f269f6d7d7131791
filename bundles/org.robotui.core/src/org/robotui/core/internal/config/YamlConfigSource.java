package org.robotui.core.internal.config;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.config.Configuration;
import org.robotui.api.host.Problem;
import org.robotui.api.host.WindowConfig;
import org.robotui.core.internal.config.model.ConfigResult;
import org.robotui.core.internal.config.model.ConfigSource;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.config.model.TypeLookup;
import org.robotui.core.internal.config.model.WrittenText;

/** Reads configuration files. */
public final class YamlConfigSource implements ConfigSource {
  private static final List<String> KEYS = List.of("simulator", "control", "windows", "bridges", "ruics");

  private final Variables variables;

  /**
   * Creates a reader.
   *
   * @param environment the variables that a file may use as {@code ${NAME}}
   */
  public YamlConfigSource(Map<String, String> environment) {
    this.variables = new Variables(environment);
  }

  @Override
  public ConfigResult read(Path file, TypeLookup types) {
    List<Problem> problems = new ArrayList<>();
    return text(file, problems).map(text -> read(file, text, types))
        .orElseGet(() -> ConfigResult.unusable(problems));
  }

  @Override
  public ConfigResult read(Path file, String text, TypeLookup types) {
    List<Problem> problems = new Mistakes();
    List<RuicConfig> ruics = new ArrayList<>();
    List<WindowConfig> windows = new ArrayList<>();
    List<BridgeConfig> bridges = new ArrayList<>();
    try {
      YamlFile.parse(file.toString(), text, variables, problems)
          .flatMap(root -> Shape.section(root, "a configuration", problems))
          .ifPresent(root -> {
            readRuics(root, types, problems, ruics);
            root.get("windows").ifPresent(v -> windows.addAll(new WindowsReader(file, names(root), problems).read(v)));
            root.get("bridges").ifPresent(v -> bridges
                .addAll(new BridgesReader(file, BridgesReader.interfaces(root), problems).read(v)));
          });
    } catch (Mistakes.TooMany e) {
      return ConfigResult.unusable(
          Stream.concat(Stream.of(whole(file, "the file has " + e.getMessage())), problems.stream()).toList());
    }
    boolean spoilt = problems.stream().anyMatch(YamlConfigSource::spoilsAll);
    return spoilt ? ConfigResult.unusable(Repeated.merged(problems))
        : new ConfigResult(Repeated.merged(problems), ruics, windows, bridges);
  }

  @Override
  public Optional<WrittenText> written(Path file, String text) {
    List<Problem> problems = new ArrayList<>();
    return YamlFile.parse(file.toString(), text, variables, problems)
        .filter(YamlValue.Section.class::isInstance).map(root -> new YamlSections((YamlValue.Section) root));
  }

  /** Problems of the file as such; those of one RUIC leave the others usable. */
  private static boolean spoilsAll(Problem problem) {
    return problem.severity() == Problem.Severity.ERROR && problem.line() == 0;
  }

  private static Optional<String> text(Path file, List<Problem> problems) {
    try {
      return Optional.of(Configuration.read(file));
    } catch (IOException e) {
      problems.add(
          whole(file, Files.exists(file) ? "the file " + e.getMessage() : "there is no such file" + neighbours(file)));
      return Optional.empty();
    }
  }

  private static Problem whole(Path file, String message) {
    return new Problem(file.toString(), 0, 1, Problem.Severity.ERROR, message);
  }

  private static String neighbours(Path file) {
    Path folder = Optional.ofNullable(file.toAbsolutePath().getParent()).orElse(file.toAbsolutePath());
    try (var entries = Files.list(folder)) {
      List<String> names = entries.map(p -> p.getFileName().toString()).filter(n -> n.endsWith(".yaml")).toList();
      return NearestWord.hint(file.getFileName().toString(), names);
    } catch (IOException e) {
      return "; the folder " + folder + " is not there either";
    }
  }

  private static void readRuics(YamlValue.Section root, TypeLookup types, List<Problem> problems,
      List<RuicConfig> ruics) {
    Shape.onlyKeys(root, KEYS, "at the top of a configuration", problems);
    Optional<YamlValue.Section> written = Shape.required(root, "ruics", "names with a section each", problems)
        .flatMap(v -> Shape.section(v, "'ruics'", problems));
    written.ifPresent(s -> s.entries().forEach(e -> readRuic(e, types, problems, ruics)));
  }

  /** Also of those that have errors. */
  private static List<String> names(YamlValue.Section root) {
    return root.get("ruics").stream()
        .flatMap(v -> v instanceof YamlValue.Section s ? s.entries().stream() : Stream.empty())
        .map(YamlValue.Entry::key).toList();
  }

  private static void readRuic(YamlValue.Entry entry, TypeLookup types, List<Problem> problems,
      List<RuicConfig> ruics) {
    List<Problem> own = new Mistakes();
    Optional<RuicConfig> ruic = new RuicReader(types, own).read(entry);
    problems.addAll(own);
    boolean usable = own.stream().noneMatch(p -> p.severity() == Problem.Severity.ERROR);
    ruic.filter(r -> usable).ifPresent(ruics::add);
  }
}
