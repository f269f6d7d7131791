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

  private static Match of(
      Want want, MatchState state, List<SourceId> peers, List<SourceId> candidates, String reason) {
    return new Match(want.id(), want.port().kind(), want.port().typeName(), want.port().arity(), state, peers,
        candidates, reason);
  }
}
