package org.robotui.rfic.recording.internal.report;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.data.Data;
import org.robotui.data.navigation.NavigationStatus;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.status.Diagnostics;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;

/** Warnings and errors, changes of what is diagnosed, goals, and what RobotUI noted. For one thread. */
final class Happenings {
  /** Who records events of RobotUI writes them by this name. */
  private static final String EVENT = "robotui.Event";
  private static final int MOST = 1000;
  /** What is said again and again is looked for among the last ones. */
  private static final int NEAR = 30;

  private final List<Happening> all = new ArrayList<>();
  private final Map<String, Diagnostics.Level> levels = new HashMap<>();
  private final Map<String, NavigationStatus.State> goals = new HashMap<>();
  private long more;

  void take(String port, long time, Data value) {
    switch (value) {
      case LogEntry entry when entry.severity().compareTo(Severity.WARNING) >= 0 -> add(time, entry.severity(),
          entry.origin(), entry.message());
      case Diagnostics report -> report.items().forEach(item -> take(time, item));
      case NavigationStatus status when goals.put(status.goal(), status.state()) != status.state() -> add(time,
          severity(status.state()), port, "goal " + word(status.state())
              + (status.text().isEmpty() ? "" : ": " + status.text()));
      case DynamicRecord event when event.schema().equals(EVENT) -> event(time, event);
      default -> {}
    }
  }

  private void take(long time, Diagnostics.Item item) {
    Diagnostics.Level before = levels.put(item.name(), item.level());
    if (before != item.level() && (before != null || item.level() != Diagnostics.Level.OK)) {
      add(time, severity(item.level()), item.name(), word(item.level())
          + (item.message().isEmpty() ? "" : ": " + item.message()));
    }
  }

  private void event(long time, DynamicRecord event) {
    String what = text(event, "event");
    boolean bad = what.equals("fault") || what.equals("alert");
    String words = sentence(what, text(event, "subject"), text(event, "value"));
    String more = text(event, "text");
    add(time, bad ? Severity.WARNING : Severity.INFO, text(event, "ui"), more.isEmpty() ? words : words + ": " + more);
  }

  private static String sentence(String event, String subject, String value) {
    return switch (event) {
      case "control" -> value.isEmpty() ? "nobody controls " + subject : value + " controls " + subject;
      case "stop" -> value.isEmpty() ? subject + " is not stopped" : subject + " is stopped by " + value;
      default -> Stream.of(event, subject, value).filter(text -> !text.isEmpty()).collect(Collectors.joining(" "));
    };
  }

  private static String text(DynamicRecord event, String field) {
    return event.field(field).filter(FieldValue.Text.class::isInstance).map(FieldValue.Text.class::cast)
        .map(FieldValue.Text::value).orElse("");
  }

  private void add(long time, Severity severity, String source, String words) {
    Happening next = new Happening(time, severity, source, words, 1);
    Optional<Integer> same = same(next);
    if (same.isPresent()) {
      all.set(same.get(), all.get(same.get()).again());
    } else if (all.size() < MOST) {
      all.add(next);
    } else {
      more++;
    }
  }

  /** A state that comes back is news, a warning that comes again is not. */
  private Optional<Integer> same(Happening next) {
    if (next.severity().compareTo(Severity.WARNING) < 0) {
      return Optional.empty();
    }
    for (int i = all.size() - 1; i >= Math.max(0, all.size() - NEAR); i--) {
      if (all.get(i).saysAs(next)) {
        return Optional.of(i);
      }
    }
    return Optional.empty();
  }

  private static String word(Enum<?> state) {
    return state.name().toLowerCase(Locale.ROOT);
  }

  private static Severity severity(Diagnostics.Level level) {
    return switch (level) {
      case OK -> Severity.INFO;
      case WARNING, STALE -> Severity.WARNING;
      case ERROR -> Severity.ERROR;
    };
  }

  private static Severity severity(NavigationStatus.State state) {
    return switch (state) {
      case ACTIVE, SUCCEEDED, CANCELED -> Severity.INFO;
      case ABORTED, REJECTED -> Severity.ERROR;
    };
  }

  /** In the order in which they were said. */
  List<Happening> all() {
    return List.copyOf(all);
  }

  /** How many more there were than are kept. */
  long more() {
    return more;
  }
}
