package org.robotui.core.internal.compose;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import org.robotui.api.RuicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.WriteFailure;
import org.robotui.api.host.CompositionText;
import org.robotui.api.host.CompositionText.Field;
import org.robotui.api.host.CompositionText.Refused;
import org.robotui.api.host.CompositionText.Text;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.Problem;
import org.robotui.api.host.RuicDraft;
import org.robotui.core.internal.config.model.ConfigResult;
import org.robotui.core.internal.config.model.ConfigSource;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.config.model.TypeLookup;

/** Makes the text of a configuration from what the user wants, reads it as it would be read later, and writes it. */
final class Drafting {
  private static final Pattern NO_NAME = Pattern.compile("[\\p{Cntrl}/${}]");
  private static final int LONGEST = 60;

  private final ConfigSource configs;
  private final TypeLookup types;
  private final InterfaceConfig robot;
  private final Supplier<List<String>> running;

  /**
   * For a robot interface.
   *
   * @param configs reads what would be written
   * @param types what is installed
   * @param robot the robot interface
   * @param running the names of the RUICs that run now
   */
  Drafting(ConfigSource configs, TypeLookup types, InterfaceConfig robot, Supplier<List<String>> running) {
    this.configs = configs;
    this.types = types;
    this.robot = robot;
    this.running = running;
  }

  CompositionText text(RuicDraft draft) {
    Optional<Refused> wrong = wrongName(draft.name()).map(why -> new Refused(Field.NAME, why))
        .or(() -> draft.views().isEmpty() ? Optional.of(new Refused(Field.VIEWS, "choose at least one view"))
            : Optional.empty());
    Optional<RuicType> type = types.ruic(draft.ruic());
    if (wrong.isPresent()) {
      return wrong.get();
    }
    if (type.isEmpty()) {
      return new Refused(Field.VIEWS,
          "no RUIC type '" + draft.ruic() + "' is installed; there are " + String.join(", ", types.ruicIds()));
    }
    ConfigFile file = new ConfigFile(draft.file());
    return file.obstacle().<CompositionText>map(why -> new Refused(Field.FILE, why))
        .orElseGet(() -> text(draft, type.get(), file));
  }

  private CompositionText text(RuicDraft draft, RuicType type, ConfigFile file) {
    Schema schema = types.rfic(robot.type()).map(t -> t.schema()).orElse(Schema.EMPTY);
    List<String> lines = new RuicText(draft, type, robot, schema).lines();
    try {
      return file.isThere() ? added(draft, lines, file.read())
          : checked(draft, Insertion.alone(lines), Optional.empty());
    } catch (IOException e) {
      return new Refused(Field.FILE, e.getMessage());
    }
  }

  private CompositionText added(RuicDraft draft, List<String> lines, String before) {
    ConfigResult former = configs.read(draft.file(), before, types);
    Optional<Problem> error = former.problems().stream().filter(p -> isError(p) && !before.isBlank()).findFirst();
    if (error.filter(p -> !p.message().startsWith("'ruics' is missing")).isPresent()) {
      return new Refused(Field.FILE, "the file has an error, which comes first: " + error.get());
    }
    if (former.ruics().stream().anyMatch(r -> r.name().equals(draft.name()))) {
      return new Refused(Field.NAME,
          "there is a '" + draft.name() + "' in " + draft.file().getFileName() + " already; choose another name");
    }
    return Insertion.into(before, lines).map(insertion -> checked(draft, insertion, Optional.of(former)))
        .orElseGet(() -> new Refused(Field.FILE, draft.file() + ":" + Insertion.sectionLine(before)
            + ": 'ruics' stands in braces there, to which nothing can be"
            + " added; write each robot UI in lines of its own below 'ruics:', without the braces, or choose a new file"));
  }

  /** What is written must be read as what was meant, and change nothing of what was there. */
  private CompositionText checked(RuicDraft draft, Insertion insertion, Optional<ConfigResult> former) {
    ConfigResult now = configs.read(draft.file(), insertion.whole(), types);
    Optional<Problem> error = now.problems().stream().filter(Drafting::isError).findFirst();
    if (error.isPresent()) {
      return new Refused(Field.ROBOT, error.get().message());
    }
    List<String> before = former.stream().flatMap(f -> f.ruics().stream()).map(RuicConfig::name).toList();
    List<String> others = now.ruics().stream().map(RuicConfig::name).filter(n -> !n.equals(draft.name())).toList();
    if (!others.equals(before) || now.ruics().size() != before.size() + 1) {
      return new Refused(Field.FILE,
          "nothing can be added to this file without changing what it says; choose a new file");
    }
    return new Text(draft.file(), insertion.whole(), insertion.added(), insertion.line(), former.isEmpty());
  }

  private static boolean isError(Problem problem) {
    return problem.severity() == Problem.Severity.ERROR;
  }

  private Optional<String> wrongName(String name) {
    if (name.isBlank()) {
      return Optional.of("the robot UI needs a name, such as Keira");
    }
    if (!name.equals(name.strip()) || name.length() > LONGEST || NO_NAME.matcher(name).find()) {
      return Optional.of("a name has at most " + LONGEST + " characters, no blanks at its ends, and none of / $ { }");
    }
    return running.get().contains(name) ? Optional.of("a robot UI '" + name + "' runs already; choose another name")
        : Optional.empty();
  }

  CompositionText write(RuicDraft draft, Text shown) {
    CompositionText now = text(draft);
    if (!(now instanceof Text text)) {
      return now;
    }
    if (!text.equals(shown)) {
      return new Refused(Field.FILE, draft.file() + " was changed meanwhile; look again at what would be written");
    }
    return write(new ConfigFile(draft.file()), text);
  }

  private static CompositionText write(ConfigFile file, Text text) {
    Path path = file.path();
    try {
      if (text.isNew()) {
        file.create(text.whole());
      } else {
        file.replace(text.whole());
      }
      return text;
    } catch (FileAlreadyExistsException e) {
      return new Refused(Field.FILE, path + " has come meanwhile; look again at what would be written");
    } catch (IOException e) {
      return new Refused(Field.FILE, path + " cannot be written: " + WriteFailure.reason(e));
    }
  }
}
