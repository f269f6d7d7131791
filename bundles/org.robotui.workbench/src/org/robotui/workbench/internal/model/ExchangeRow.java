package org.robotui.workbench.internal.model;

import java.util.Comparator;
import java.util.List;
import org.robotui.api.host.ExchangePreview;
import org.robotui.api.host.ExchangePreview.Line;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Health;
import org.robotui.ui.MatchLook;

/**
 * One connection in the preview of an exchange.
 *
 * @param port the view's port
 * @param kind what passes through
 * @param health what to think of it
 * @param state a word
 * @param type what the view wants or gives
 * @param now the connected ports
 * @param then the ports that it would be connected to
 * @param why the reason
 * @param candidates the ports that the user can choose, empty where there is no choice
 */
public record ExchangeRow(SourceId port, PortKind kind, Health health, String state, String type, String now,
    String then, String why,
    List<SourceId> candidates) {
  private static final String NOTHING = "\u2013";

  /** Rows of a preview: what is lost first, then what is to be chosen, then the others in their order. */
  public static List<ExchangeRow> of(ExchangePreview preview) {
    return preview.lines().stream().sorted(Comparator.comparingInt(ExchangeRow::rank)).map(ExchangeRow::of).toList();
  }

  private static int rank(Line line) {
    return line.lost() ? 0 : line.then().state() == MatchState.AMBIGUOUS ? 1 : line.concerned() ? 2 : 3;
  }

  private static ExchangeRow of(Line line) {
    Match then = line.then();
    Health health = line.lost() ? Health.BAD : MatchLook.health(then);
    return new ExchangeRow(then.port(), then.kind(), health, line.lost() ? "lost" : MatchLook.word(then),
        then.typeName(),
        peers(line.now()), peers(then), then.reason(),
        then.state() == MatchState.AMBIGUOUS ? then.candidates() : List.of());
  }

  private static String peers(Match match) {
    String peers = MatchLook.peers(match);
    boolean chooses = peers.isEmpty() && match.state() == MatchState.CONNECTED;
    return peers.isEmpty() ? chooses ? "the view chooses" : NOTHING : peers;
  }
}
