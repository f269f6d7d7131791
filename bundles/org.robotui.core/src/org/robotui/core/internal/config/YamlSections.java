package org.robotui.core.internal.config;

import java.util.List;
import java.util.Optional;
import org.robotui.core.internal.config.model.RawSection;
import org.robotui.core.internal.config.model.WrittenText;

/**
 * The sections of a text that was read.
 *
 * @param root all of it
 */
record YamlSections(YamlValue.Section root) implements WrittenText {
  @Override
  public Optional<RawSection> at(List<String> path) {
    Optional<YamlValue> value = Optional.of(root);
    for (String name : path) {
      value = value.filter(YamlValue.Section.class::isInstance).map(YamlValue.Section.class::cast)
          .flatMap(s -> s.get(name));
    }
    return value.flatMap(YamlSections::section).map(WrittenSection::new);
  }

  private static Optional<YamlValue.Section> section(YamlValue value) {
    return switch (value) {
      case YamlValue.Section s -> Optional.of(s);
      case YamlValue.Scalar s when !s.isEmpty() -> Optional.of(ComponentReader.oneWord(s));
      default -> Optional.empty();
    };
  }

  @Override
  public int line(List<String> path) {
    int line = root.place().line();
    YamlValue at = root;
    for (String name : path) {
      Optional<YamlValue.Entry> entry = at instanceof YamlValue.Section s ? s.entry(name) : Optional.empty();
      if (entry.isEmpty()) {
        return line;
      }
      line = entry.get().place().line();
      at = entry.get().value();
    }
    return line;
  }
}
