package org.robotui.core.internal.config;

import java.util.List;
import java.util.Optional;
import org.robotui.api.ComponentType;
import org.robotui.api.config.Settings;
import org.robotui.api.host.Problem;
import org.robotui.core.internal.config.model.CheckedSettings;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.FixedWords;
import org.robotui.core.internal.config.model.TypeLookup;

/** Reads robot interfaces and views. */
final class ComponentReader {
  private final TypeLookup types;
  private final List<Problem> problems;

  ComponentReader(TypeLookup types, List<Problem> problems) {
    this.types = types;
    this.problems = problems;
  }

  List<ComponentConfig> rfics(YamlValue.Section section, String ruic) {
    return section.entries().stream().flatMap(e -> rfic(e, ruic).stream()).toList();
  }

  List<ComponentConfig> uics(YamlValue.Section section, Brought brought) {
    return section.entries().stream().flatMap(e -> uic(e, brought).stream()).toList();
  }

  private Optional<ComponentConfig> rfic(YamlValue.Entry entry, String ruic) {
    return body(entry).flatMap(section -> {
      String robot = text(section, "robot").orElse(ruic);
      Optional<String> type = Shape.required(section, "type", "the framework, one of " + types.rficIds(), problems)
          .flatMap(v -> Shape.text(v, "'type'", problems));
      return type.map(t -> {
        YamlValue.Section own = section.without(List.of("type", "title", "robot"));
        check(types.rfic(t), t, "robot interface", types.rficIds(), section, own);
        return component(entry, t, text(section, "title").orElse(""), robot, own);
      });
    });
  }

  private Optional<ComponentConfig> uic(YamlValue.Entry entry, Brought brought) {
    return body(entry).map(section -> {
      String type = text(section, "type").orElse(brought.views().mayHave(entry.key()) ? "" : entry.key());
      YamlValue.Section own = section.without(List.of("type", "title"));
      // That a product lacks a view which the robot UI brings along is no mistake of the file.
      Optional<String> judged =
          type.isEmpty() ? brought.typeOf(entry.key()).filter(t -> types.uic(t).isPresent()) : Optional.of(type);
      judged.ifPresent(t -> check(types.uic(t), t, "view", types.uicIds(), section, own));
      return component(entry, type, text(section, "title").orElse(""), "", own);
    });
  }

  /** What a component consists of; a word alone is its type. */
  private Optional<YamlValue.Section> body(YamlValue.Entry entry) {
    if (!entry.key().matches(FixedWords.ID)) {
      problems.add(entry.place().error("'" + entry.key() + "' is no id; use letters, digits, '_' and '-'"));
    }
    if (entry.value() instanceof YamlValue.Scalar s && !s.isEmpty()) {
      return Optional.of(oneWord(s));
    }
    return Shape.section(entry.value(), "'" + entry.key() + "'", problems);
  }

  /** A component that is written as its type alone. */
  static YamlValue.Section oneWord(YamlValue.Scalar type) {
    return new YamlValue.Section(List.of(new YamlValue.Entry("type", type.place(), type)), type.place());
  }

  private Optional<String> text(YamlValue.Section section, String key) {
    return section.get(key).flatMap(v -> Shape.text(v, "'" + key + "'", problems));
  }

  private void check(
      Optional<? extends ComponentType> type,
      String id,
      String what,
      List<String> installed,
      YamlValue.Section section,
      YamlValue.Section own) {
    if (type.isEmpty()) {
      Place at = section.get("type").map(YamlValue::place).orElse(section.place());
      problems.add(at.warning("no " + what + " type '" + id + "' is installed" + NearestWord.hint(id, installed)));
    } else {
      switch (new SchemaCheck().check(type.get().schema(), new WrittenSection(own))) {
        case CheckedSettings.Invalid i -> problems.addAll(i.problems());
        case CheckedSettings.Valid v -> problems.addAll(faults(type.get(), v.settings(), section.place()));
      }
    }
  }

  /** What a type says of settings is foreign code. */
  private static List<Problem> faults(ComponentType type, Settings settings, Place at) {
    try {
      return type.faults(settings).stream()
          .map(
              f -> (f.file().isEmpty() ? at : new Place(f.file(), f.line(), f.column(), at.robot())).error(f.message()))
          .toList();
    } catch (RuntimeException | LinkageError e) {
      return List.of(at.error("'" + type.id() + "' cannot judge these settings: " + e));
    }
  }

  private static ComponentConfig component(
      YamlValue.Entry entry, String type, String title, String robot, YamlValue.Section own) {
    Place at = entry.place();
    return new ComponentConfig(
        entry.key(), type, title, robot, new WrittenSection(own), at.file(), at.line(), at.column());
  }
}
