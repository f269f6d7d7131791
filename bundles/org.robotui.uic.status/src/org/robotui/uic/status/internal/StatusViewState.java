package org.robotui.uic.status.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.api.port.PortKind;
import org.robotui.data.DataType;
import org.robotui.data.status.LogEntry;
import org.robotui.ui.Health;
import org.robotui.ui.MatchLook;

/**
 * All that the view knows, at one moment.
 *
 * @param ruic how the robot's interface is doing
 * @param batteries a line each
 * @param stoppedBy who latched the stop
 * @param connections whether connections are shown in place of ports
 */
record StatusViewState(RuicSnapshot ruic, List<StatusRow> batteries, Optional<String> stoppedBy, boolean connections) {
  private static final String UNUSED = "OFFERED, NOT USED BY A VIEW";
  private static final String LOGS = "LOGS OF THE ROBOT'S PROGRAMS";
  private static final String LOG_TYPE = DataType.of(LogEntry.class).name();

  /** What is seen of it. */
  Page page(String filter) {
    return new Page(rows(filter), trouble(), note(), stoppedBy, connections);
  }

  /** The lines that contain some words, in an order that does not change with the values. */
  List<StatusRow> rows(String filter) {
    String wanted = filter.strip().toLowerCase(Locale.ROOT);
    return (connections ? connectionRows() : statusRows(wanted)).stream().filter(row -> fits(row, wanted)).toList();
  }

  /** What is said where there is nothing to list, with its dot. */
  Optional<Page.Trouble> trouble() {
    if (ruic.state() == RuicState.FAILED) {
      return Optional.of(new Page.Trouble(Health.BAD, ruic.name() + " failed", ruic.reason()));
    }
    boolean nothing = ruic.components().isEmpty() && ruic.ports().isEmpty() && ruic.matches().isEmpty();
    return nothing
        ? Optional.of(new Page.Trouble(Health.NONE, "Nothing configured",
            "Add a robot interface, for example ros, to " + ruic.name() + "."))
        : Optional.empty();
  }

  /** What stands at the right of the view's title. */
  String note() {
    // Calls and lists are always there: only what flows is in use or not.
    List<PortStatus> flows = ruic.ports().stream()
        .filter(port -> port.kind() == PortKind.STREAM || port.kind() == PortKind.COMMAND).toList();
    long used = flows.stream().filter(PortStatus::wanted).count();
    return "link " + ruic.link().word() + " \u00b7 " + used + " of " + flows.size() + " ports in use";
  }

  private List<StatusRow> connectionRows() {
    return ruic.matches().stream().map(MatchRows::of).toList();
  }

  private List<StatusRow> statusRows(String wanted) {
    List<StatusRow> rows = new ArrayList<>();
    boolean several = several();
    ruic.components().stream().flatMap(LinkRows::of).forEach(rows::add);
    rows.addAll(batteries);
    ports(true).map(port -> new PortRow(port, several)).forEach(rows::add);
    ruic.matches().stream().filter(MatchLook::missing).map(MatchRows::note).forEach(rows::add);
    section(UNUSED, ports(false).map(port -> new PortRow(port, several)), wanted, rows);
    section(LOGS, shown().filter(StatusViewState::isLog).map(port -> new PortRow(port, several)), wanted, rows);
    return rows;
  }

  private static void section(String head, Stream<StatusRow> ports, String wanted, List<StatusRow> rows) {
    List<StatusRow> section = ports.filter(row -> fits(row, wanted)).toList();
    if (!section.isEmpty()) {
      rows.add(new StatusRow.Head(head));
      rows.addAll(section);
    }
  }

  private Stream<PortStatus> ports(boolean wanted) {
    return shown().filter(port -> port.wanted() == wanted && !isLog(port));
  }

  private Stream<PortStatus> shown() {
    return ruic.ports().stream().filter(port -> port.kind() != PortKind.BROWSE);
  }

  /** What the robot's programs write is no measurement of the robot. */
  private static boolean isLog(PortStatus port) {
    return port.typeName().equals(LOG_TYPE);
  }

  private boolean several() {
    return ruic.ports().stream().map(p -> p.port().component()).distinct().limit(2).count() > 1;
  }

  private static boolean fits(StatusRow row, String wanted) {
    return wanted.isEmpty() || row.says(wanted);
  }
}
