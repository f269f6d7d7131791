package org.robotui.core.internal.match;

import java.util.List;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.port.SourceId;

/** Makes the results. */
final class Matches {
  private Matches() {}

  static Match connected(Want want, List<SourceId> peers, String reason) {
    return of(want, MatchState.CONNECTED, peers, List.of(), reason);
  }

  /** Of a port whose view chooses: what fits are candidates, and peers are only what the view has chosen. */
  static Match offered(Want want, List<SourceId> candidates, String reason) {
    return of(want, MatchState.CONNECTED, List.of(), candidates, reason);
  }

  static Match without(Want want, MatchState state, String reason) {
    return of(want, state, List.of(), List.of(), reason);
  }

  static Match ambiguous(Want want, List<SourceId> candidates, String reason) {
    return of(want, MatchState.AMBIGUOUS, List.of(), candidates, reason);
  }

  /** Of a port for one robot beside a port for all of them. */
  static Match covered(Match match, Match all) {
    SourceId first = match.candidates().getFirst();
    return new Match(match.port(), match.kind(), match.typeName(), match.arity(), MatchState.REFUSED, List.of(),
        match.candidates(),
        "not needed: '" + all.port().port() + "' takes all " + match.candidates().size()
            + " ports of its type, and the view sends to those that are selected. "
            + "For one alone write under 'connect':  " + match.port() + ": " + first);
  }

  private static Match of(
      Want want, MatchState state, List<SourceId> peers, List<SourceId> candidates, String reason) {
    return new Match(want.id(), want.port().kind(), want.port().typeName(), want.port().arity(), state, peers,
        candidates, reason);
  }
}
