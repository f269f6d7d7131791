package org.robotui.core.internal.config;

import java.util.List;
import java.util.Optional;
import org.robotui.api.host.Problem;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.config.model.ConnectionConfig;

/** Reads named connections: {@code view.port: interface.port}, a list of these, or {@code none}. */
final class ConnectionReader {
  private final Known views;
  private final Known rfics;
  private final List<Problem> problems;

  ConnectionReader(Known views, Known rfics, List<Problem> problems) {
    this.views = views;
    this.rfics = rfics;
    this.problems = problems;
  }

  List<ConnectionConfig> read(YamlValue.Section section) {
    return section.entries().stream().flatMap(e -> connection(e).stream()).toList();
  }

  private Optional<ConnectionConfig> connection(YamlValue.Entry entry) {
    return port(entry.key(), entry.place(), views, "view")
        .map(port -> new ConnectionConfig(port, peers(entry.value()), entry.place().line(), entry.place().column()));
  }

  private List<SourceId> peers(YamlValue value) {
    if (value instanceof YamlValue.Scalar s && "none".equals(s.text())) {
      return List.of();
    }
    return Shape.items(value).stream().flatMap(v -> peer(v).stream()).toList();
  }

  private Optional<SourceId> peer(YamlValue value) {
    return Shape.text(value, "a connection", problems)
        .flatMap(text -> port(text, value.place(), rfics, "robot interface"));
  }

  private Optional<SourceId> port(String text, Place place, Known components, String what) {
    int dot = text.indexOf('.');
    if (dot <= 0 || dot == text.length() - 1) {
      problems.add(place.error("'" + text + "' is no port; write " + what.replace(' ', '-') + ".port, for example "
          + components.any().orElse("base") + ".scan"));
      return Optional.empty();
    }
    String component = text.substring(0, dot);
    if (!components.mayHave(component)) {
      problems.add(
          place.error("there is no " + what + " '" + component + "'" + NearestWord.hint(component, components.ids())));
      return Optional.empty();
    }
    return Optional.of(new SourceId(component, text.substring(dot + 1)));
  }
}
