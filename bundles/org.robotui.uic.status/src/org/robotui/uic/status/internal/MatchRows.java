package org.robotui.uic.status.internal;

import java.util.stream.Collectors;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Health;
import org.robotui.ui.Role;

/** Lines of connections. */
final class MatchRows {
  private MatchRows() {}

  /** Whether a view lacks what it cannot do without. */
  static boolean missing(Match match) {
    return match.state() != MatchState.CONNECTED && (match.arity() == Arity.ONE || match.state() == MatchState.AMBIGUOUS);
  }

  static Row note(Match match) {
    return new Row.Note("note " + match.kind() + " " + match.port(), Role.WARNING, match.port() + ": " + match.reason());
  }

  static Row of(Match match) {
    String peers = match.peers().stream().map(SourceId::toString).collect(Collectors.joining(", "));
    String text = match.state() == MatchState.CONNECTED ? peers : match.reason();
    return new Row.Item("match " + match.kind() + " " + match.port(), health(match), match.port().toString(), word(match), "", "",
        text, match.port() + "\n" + match.typeName() + "\n" + word(match) + (peers.isEmpty() ? "" : ": " + peers) + "\n" + match.reason());
  }

  private static Health health(Match match) {
    return switch (match.state()) {
      case CONNECTED -> Health.OK;
      case AMBIGUOUS -> Health.WARNING;
      case PENDING -> missing(match) ? Health.WAITING : Health.NONE;
      case REFUSED -> missing(match) ? Health.BAD : Health.NONE;
    };
  }

  private static String word(Match match) {
    return switch (match.state()) {
      case CONNECTED -> "connected";
      case AMBIGUOUS -> "ambiguous";
      case PENDING -> "pending";
      case REFUSED -> "refused";
    };
  }
}
