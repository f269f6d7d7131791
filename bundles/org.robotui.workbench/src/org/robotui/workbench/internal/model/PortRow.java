package org.robotui.workbench.internal.model;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.port.Arity;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;

/**
 * A port in the navigator.
 *
 * @param name the port
 * @param health the dot
 * @param figure its rate, or a word
 * @param age of the newest value; empty where the word says it, or where it does not matter
 * @param hint all that is known, for the tooltip
 * @param port the stream that it stands for, none for what is not offered
 */
public record PortRow(String name, Health health, String figure, String age, String hint, Optional<SourceId> port) {
  /** More than this of what nobody looks at is for the views that list all of it. */
  private static final int MOST_OFFERED = 40;

  /** What views want first, then what they miss, then the first of what nobody looks at. */
  public static List<PortRow> of(RuicSnapshot ruic) {
    boolean several = ruic.ports().stream().map(p -> p.port().component()).distinct().limit(2).count() > 1;
    Stream<PortRow> wanted = streams(ruic, true).map(port -> wanted(port, several));
    Stream<PortRow> missing = ruic.matches().stream().filter(PortRow::isMissed).map(PortRow::missing);
    Stream<PortRow> offered = streams(ruic, false).limit(MOST_OFFERED).map(port -> offered(port, several));
    return Stream.of(wanted, missing, offered, more(ruic).stream()).flatMap(s -> s).toList();
  }

  private static Optional<PortRow> more(RuicSnapshot ruic) {
    long more = ruic.ports().stream().filter(p -> p.kind() == PortKind.STREAM && !p.wanted()).count() - MOST_OFFERED;
    return more <= 0 ? Optional.empty()
        : Optional.of(new PortRow("and " + more + " more", Health.NONE, "offered", "",
            "The topics view lists all that the robot has.", Optional.empty()));
  }

  private static Stream<PortStatus> streams(RuicSnapshot ruic, boolean wanted) {
    return ruic.ports().stream()
        .filter(p -> p.kind() == PortKind.STREAM && p.wanted() == wanted)
        .sorted(Comparator.comparing(p -> p.port().port()));
  }

  private static PortRow wanted(PortStatus port, boolean several) {
    return new PortRow(shown(port.port(), several), health(port), figure(port), age(port), hint(port),
        Optional.of(port.port()));
  }

  private static PortRow offered(PortStatus port, boolean several) {
    return new PortRow(shown(port.port(), several), Health.NONE, "offered", "", hint(port), Optional.of(port.port()));
  }

  private static boolean isMissed(Match match) {
    return match.kind() == PortKind.STREAM && match.arity() == Arity.ONE && match.state() != MatchState.CONNECTED;
  }

  private static PortRow missing(Match match) {
    String word = switch (match.state()) {
      case PENDING -> "not yet";
      case AMBIGUOUS -> "choose one";
      case REFUSED, CONNECTED -> "not offered";
    };
    Health health = match.state() == MatchState.AMBIGUOUS ? Health.WARNING : Health.NONE;
    return new PortRow(match.port().toString(), health, word, "",
        match.port() + " (" + match.typeName() + ")\n" + match.reason(), Optional.empty());
  }

  private static Health health(PortStatus port) {
    if (port.stale()) {
      return Health.STALE;
    }
    if (!port.problem().isEmpty()) {
      return Health.BAD;
    }
    return port.count() == 0 ? Health.WAITING : Health.OK;
  }

  private static String figure(PortStatus port) {
    if (port.stale()) {
      return "stale " + Figures.ageOfValue(port.ageSeconds());
    }
    if (!port.problem().isEmpty()) {
      return "failed";
    }
    if (port.count() == 0) {
      return "waiting";
    }
    return port.rateHz() > 0 ? Figures.rate(port.rateHz()) : "event";
  }

  private static String age(PortStatus port) {
    return health(port) == Health.OK && port.rateHz() > 0 ? Figures.ageOfValue(port.ageSeconds()) : "";
  }

  private static String hint(PortStatus port) {
    String head = port.port() + " (" + port.typeName() + ")";
    String figures = Figures.rate(port.rateHz()) + ", age " + Figures.ageOfValue(port.ageSeconds())
        + ", " + port.count() + " values, " + port.dropped() + " dropped";
    String said = port.problem().isEmpty() ? port.value() : port.problem();
    return head + "\n" + figures + (said.isEmpty() ? "" : "\n" + said);
  }

  /** Of several robot interfaces each may have a port of this name: it is said whose it is. */
  private static String shown(SourceId port, boolean several) {
    return several ? port.toString() : port.port().startsWith("/") ? port.port().substring(1) : port.port();
  }
}
