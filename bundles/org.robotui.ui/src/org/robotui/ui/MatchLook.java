package org.robotui.ui;

import java.util.stream.Collectors;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.SourceId;

/** How connections of views look, the same in all views that list them. Pure, for all threads. */
public final class MatchLook {
  private MatchLook() {}

  /**
   * Whether a view lacks what it cannot do without, or the user must decide.
   *
   * @param match what matching says of a port
   * @return false also where an optional port is not connected: that is no fault
   */
  public static boolean missing(Match match) {
    return match.state() != MatchState.CONNECTED
        && (match.arity() == Arity.ONE || match.state() == MatchState.AMBIGUOUS);
  }

  /**
   * The dot of a connection.
   *
   * @param match what matching says of a port
   * @return its health; none where an optional port is not connected
   */
  public static Health health(Match match) {
    return switch (match.state()) {
      case CONNECTED -> Health.OK;
      case AMBIGUOUS -> Health.WARNING;
      case PENDING -> missing(match) ? Health.WAITING : Health.NONE;
      case REFUSED -> missing(match) ? Health.BAD : Health.NONE;
    };
  }

  /**
   * The word of a connection.
   *
   * @param match what matching says of a port
   * @return for example {@code ambiguous}
   */
  public static String word(Match match) {
    return switch (match.state()) {
      case CONNECTED -> "connected";
      case AMBIGUOUS -> "ambiguous";
      case PENDING -> "pending";
      case REFUSED -> "refused";
    };
  }

  /**
   * The connected ports.
   *
   * @param match what matching says of a port
   * @return their names, or empty
   */
  public static String peers(Match match) {
    return match.peers().stream().map(SourceId::toString).collect(Collectors.joining(", "));
  }

  /**
   * What is to be said of a connection: with what, else why not.
   *
   * @param match what matching says of a port
   * @return names or a sentence
   */
  public static String text(Match match) {
    return match.state() == MatchState.CONNECTED ? peers(match) : match.reason();
  }

  /**
   * Everything about a connection, for tooltip and clipboard.
   *
   * @param match what matching says of a port
   * @return several lines
   */
  public static String details(Match match) {
    String peers = peers(match);
    return match.port() + "\n" + match.typeName() + "\n" + word(match) + (peers.isEmpty() ? "" : ": " + peers) + "\n"
        + match.reason();
  }
}
