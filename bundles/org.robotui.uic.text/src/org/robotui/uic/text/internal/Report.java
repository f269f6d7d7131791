package org.robotui.uic.text.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;

/**
 * All that is shown, and how it is laid out in a terminal.
 *
 * @param ruic how the robot's interface is doing
 * @param standing who drives
 * @param alarms what somebody should see
 * @param unused whether ports are listed that no view uses
 * @param types whether types are listed where there is room
 */
record Report(RuicSnapshot ruic, Standing standing, Alarms alarms, boolean unused, boolean types) {
  private static final int ROOM_FOR_TYPES = 100;
  private static final int SHARE_OF_TROUBLES = 3;
  private static final int SHARE_OF_ALARMS = 3;

  List<String> lines(int columns, int rows) {
    List<String> head = head(columns);
    List<String> troubles = troubles();
    int kept = Math.min(troubles.size(), Math.max(0, (rows - head.size()) / SHARE_OF_TROUBLES));
    List<String> lines = new ArrayList<>(head);
    int most = Math.max(0, (rows - head.size()) / SHARE_OF_ALARMS);
    lines.addAll(limited(alarms.lines(), most, "alerts"));
    lines.addAll(limited(ports(columns), Math.max(0, rows - lines.size() - kept), "ports"));
    lines.addAll(limited(troubles, Math.max(0, rows - lines.size()), "reasons"));
    return lines.stream().limit(Math.max(0, rows)).map(line -> Columns.cut(line.stripTrailing(), columns)).toList();
  }

  private List<String> head(int columns) {
    String left = Columns.safe(ruic.name()) + "  " + link(ruic.link());
    String right = Columns.safe(standing.text());
    List<String> lines = new ArrayList<>();
    lines.add(Columns.spread(left, right, columns));
    if (ruic.state() == RuicState.FAILED) {
      lines.add("failed: " + Columns.safe(ruic.reason()));
    }
    ruic.components().stream().filter(c -> !isView(c)).flatMap(Report::component).forEach(lines::add);
    lines.add("");
    return lines;
  }

  private static boolean isView(ComponentStatus component) {
    return component.kind() == ComponentStatus.Kind.UIC;
  }

  private static Stream<String> component(ComponentStatus component) {
    String name = "  " + Columns.safe(component.id()) + " (" + Columns.safe(component.type()) + ")  ";
    if (component.state() == RuicState.FAILED) {
      return Stream.of(name + "failed: " + Columns.safe(component.reason()));
    }
    return component.link().map(link -> name + link(link)).stream();
  }

  private static String link(LinkState link) {
    String peer = switch (link) {
      case LinkState.Connected connected -> connected.peer();
      case LinkState.Degraded degraded -> degraded.peer() + ", " + degraded.reason();
      default -> link.reason();
    };
    return Columns.safe(peer.isBlank() ? link.word() : link.word() + ": " + peer);
  }

  private List<String> ports(int columns) {
    List<PortStatus> shown = ruic.ports().stream().filter(port -> unused || port.wanted()).toList();
    return shown.isEmpty() ? List.of("no ports yet")
        : new PortTable(shown, types && columns >= ROOM_FOR_TYPES).lines(columns);
  }

  private List<String> troubles() {
    // Views for windows do not run here: that is said last, after what the robot offers.
    return Stream.of(
        ruic.matches().stream().filter(match -> match.state() != MatchState.CONNECTED).map(Report::trouble),
        views(false).flatMap(Report::component),
        windowViews().stream())
        .flatMap(lines -> lines).toList();
  }

  private Stream<ComponentStatus> views(boolean absent) {
    return ruic.components().stream().filter(view -> isView(view) && isAbsent(view) == absent);
  }

  /** Where there are no windows, the types of views for windows are not installed: no fault, and a line is enough. */
  private static boolean isAbsent(ComponentStatus view) {
    return view.state() == RuicState.FAILED && view.reason().startsWith("type '" + view.type() + "' is not installed");
  }

  private Optional<String> windowViews() {
    String names = views(true)
        .map(view -> Columns.safe(view.id().equals(view.type()) ? view.id() : view.id() + " (" + view.type() + ")"))
        .collect(Collectors.joining(", "));
    return names.isEmpty() ? Optional.empty() : Optional.of("not shown in a terminal, needs a window: " + names);
  }

  private static String trouble(Match match) {
    String word = switch (match.state()) {
      case PENDING -> "waiting";
      case REFUSED -> "refused";
      case AMBIGUOUS -> "ambiguous";
      case CONNECTED -> "connected";
    };
    return Columns.safe(word + "  " + match.port() + ": " + match.reason());
  }

  /** The first lines, the last of them saying how many more there are. */
  private static List<String> limited(List<String> lines, int most, String what) {
    if (lines.size() <= most) {
      return lines;
    }
    if (most == 0) {
      return List.of();
    }
    List<String> limited = new ArrayList<>(lines.subList(0, most - 1));
    limited.add("\u2026 " + (lines.size() - most + 1) + " more " + what);
    return limited;
  }
}
