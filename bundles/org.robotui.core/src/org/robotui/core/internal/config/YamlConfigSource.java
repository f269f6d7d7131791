package org.robotui.core.internal.config;

import java.io.IOException;
import java.nio.charset.MalformedInputException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.host.Problem;
import org.robotui.core.internal.config.model.ConfigResult;
import org.robotui.core.internal.config.model.ConfigSource;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.config.model.TypeLookup;

/** Reads configuration files. */
public final class YamlConfigSource implements ConfigSource {
  private static final List<String> KEYS = List.of("simulator", "control", "ruics");
  private static final long MAX_BYTES = 1 << 20;

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
    List<RuicConfig> ruics = new ArrayList<>();
    text(file, problems)
        .flatMap(text -> YamlFile.parse(file.toString(), text, variables, problems))
        .ifPresent(root -> readRoot(root, types, problems, ruics));
    return new ConfigResult(Repeated.merged(problems), problems.stream().anyMatch(YamlConfigSource::spoilsAll) ? List.of() : ruics);
  }

  /** Problems of the file as such; those of one RUIC leave the others usable. */
  private static boolean spoilsAll(Problem problem) {
    return problem.severity() == Problem.Severity.ERROR && problem.line() == 0;
  }

  private static Optional<String> text(Path file, List<Problem> problems) {
    try {
      if (Files.size(file) > MAX_BYTES) {
        problems.add(whole(file, "is larger than a configuration can be (" + MAX_BYTES + " bytes)"));
        return Optional.empty();
      }
      return Optional.of(Files.readString(file));
    } catch (NoSuchFileException e) {
      problems.add(whole(file, "there is no such file" + neighbours(file)));
    } catch (MalformedInputException e) {
      problems.add(whole(file, "is no UTF-8 text"));
    } catch (IOException e) {
      problems.add(whole(file, "cannot be read: " + e.getMessage()));
    }
    return Optional.empty();
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

  private void readRoot(YamlValue root, TypeLookup types, List<Problem> problems, List<RuicConfig> ruics) {
    Optional<YamlValue.Section> section = Shape.section(root, "a configuration", problems);
    section.ifPresent(s -> Shape.onlyKeys(s, KEYS, "at the top of a configuration", problems));
    Optional<YamlValue.Section> written = section.flatMap(s -> Shape.required(s, "ruics", "names with a section each", problems))
        .flatMap(v -> Shape.section(v, "'ruics'", problems));
    written.ifPresent(s -> s.entries().forEach(e -> readRuic(e, types, problems, ruics)));
  }

  private static void readRuic(YamlValue.Entry entry, TypeLookup types, List<Problem> problems, List<RuicConfig> ruics) {
    List<Problem> own = new ArrayList<>();
    Optional<RuicConfig> ruic = new RuicReader(types, own).read(entry);
    problems.addAll(own);
    boolean usable = own.stream().noneMatch(p -> p.severity() == Problem.Severity.ERROR);
    ruic.filter(r -> usable).ifPresent(ruics::add);
  }
}
