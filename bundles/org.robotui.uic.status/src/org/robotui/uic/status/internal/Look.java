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
import org.robotui.ui.Health;

/**
 * All that the view shows, at one moment.
 *
 * @param ruic how the robot's interface is doing
 * @param batteries a line each
 * @param stoppedBy who latched the stop
 * @param connections whether connections are shown in place of ports
 */
record Look(RuicSnapshot ruic, List<Row> batteries, Optional<String> stoppedBy, boolean connections) {
  private static final String UNUSED = "OFFERED, NOT USED BY A VIEW";

  /** The lines that contain some words, in an order that does not change with the values. */
  List<Row> rows(String filter) {
    String wanted = filter.strip().toLowerCase(Locale.ROOT);
    return (connections ? connectionRows() : statusRows(wanted)).stream().filter(row -> fits(row, wanted)).toList();
  }

  /** What is said where there is nothing to list, with its dot. */
  Optional<Trouble> trouble() {
    if (ruic.state() == RuicState.FAILED) {
      return Optional.of(new Trouble(Health.BAD, ruic.name() + " failed", ruic.reason()));
    }
    boolean nothing = ruic.components().isEmpty() && ruic.ports().isEmpty() && ruic.matches().isEmpty();
    return nothing
        ? Optional.of(new Trouble(Health.NONE, "Nothing configured", "Add a robot interface, for example ros, to " + ruic.name() + "."))
        : Optional.empty();
  }

  /** What stands at the right of the view's title. */
  String note() {
    long used = ruic.ports().stream().filter(PortStatus::wanted).count();
    return "link " + ruic.link().word() + " \u00b7 " + used + " of " + ruic.ports().size() + " ports in use";
  }

  private List<Row> connectionRows() {
    return ruic.matches().stream().map(MatchRows::of).toList();
  }

  private List<Row> statusRows(String wanted) {
    List<Row> rows = new ArrayList<>();
    ruic.components().stream().flatMap(LinkRows::of).forEach(rows::add);
    rows.addAll(batteries);
    ports(true).map(this::row).forEach(rows::add);
    ruic.matches().stream().filter(MatchRows::missing).map(MatchRows::note).forEach(rows::add);
    List<Row> unused = ports(false).map(this::row).filter(row -> fits(row, wanted)).toList();
    if (!unused.isEmpty()) {
      rows.add(new Row.Head(UNUSED));
      rows.addAll(unused);
    }
    return rows;
  }

  private Stream<PortStatus> ports(boolean wanted) {
    return ruic.ports().stream().filter(port -> port.wanted() == wanted && port.kind() != PortKind.BROWSE);
  }

  private Row row(PortStatus port) {
    return PortRows.of(port, ruic.ports().stream().map(p -> p.port().component()).distinct().count() > 1);
  }

  private static boolean fits(Row row, String wanted) {
    return row instanceof Row.Head || row.details().toLowerCase(Locale.ROOT).contains(wanted);
  }

  /**
   * Why there is nothing to list.
   *
   * @param health the dot
   * @param title a few words
   * @param sentence what would help
   */
  record Trouble(Health health, String title, String sentence) {}
}
