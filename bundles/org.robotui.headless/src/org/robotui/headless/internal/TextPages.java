package org.robotui.headless.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.robotui.api.TextUic;
import org.robotui.api.config.Printable;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.Host;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicSnapshot;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The lines of all RUICs, one below the other: what their text views say, or a summary of those that have none. */
final class TextPages {
  private static final Logger LOG = LoggerFactory.getLogger(TextPages.class);

  private final Host host;

  TextPages(Host host) {
    this.host = host;
  }

  List<String> lines(int columns, int rows) {
    List<Ruic> ruics = host.ruics();
    if (ruics.isEmpty()) {
      return List.of("no robot is configured; start with -config FILE");
    }
    int share = Math.max(1, rows / ruics.size());
    return ruics.stream().flatMap(r -> page(r, columns, share)).map(l -> fit(l, columns)).toList();
  }

  private static Stream<String> page(Ruic ruic, int columns, int rows) {
    RuicSnapshot snapshot = ruic.snapshot();
    List<TextView> views = views(ruic, snapshot);
    List<String> lines = new ArrayList<>();
    if (views.isEmpty()) {
      lines.addAll(Summary.lines(snapshot));
      snapshot.components().stream().filter(c -> !c.reason().isEmpty()).map(Summary::failure).forEach(lines::add);
    }
    for (TextView view : views) {
      lines.addAll(view.lines(columns, Math.max(1, rows / views.size())));
    }
    return lines.stream().limit(rows);
  }

  private static List<TextView> views(Ruic ruic, RuicSnapshot snapshot) {
    return snapshot.components().stream()
        .filter(c -> c.kind() == ComponentStatus.Kind.UIC)
        .flatMap(c -> ruic.uic(c.id())
            .filter(TextUic.class::isInstance)
            .map(u -> new TextView(ruic, c.id(), (TextUic) u))
            .stream())
        .toList();
  }

  /** Keeps what would steer the terminal away from it. */
  static String fit(String line, int columns) {
    String clean = Printable.of(line).codePoints()
        .limit(columns)
        .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
        .toString();
    return clean.stripTrailing();
  }

  /** A running text view; one that throws fails alone. */
  private record TextView(Ruic ruic, String id, TextUic uic) {
    List<String> lines(int columns, int rows) {
      try {
        return uic.lines(columns, rows);
      } catch (RuntimeException | Error e) {
        LOG.warn("view {} of {} failed", id, ruic.name(), e);
        ruic.surfaceFailed(id, "its text could not be made: " + e);
        return List.of();
      }
    }
  }
}
