package org.robotui.core.internal.match;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.SourceId;

/** A port whose connections somebody named: these or none. */
record NamedMatch(Want want, Choice choice, List<Have> haves, List<Supplier> suppliers) {
  /** What became of one named peer: connected where the state says so, else the reason why not. */
  private record Peer(SourceId id, MatchState state, String reason) {}

  Match match() {
    if (choice.peers().isEmpty()) {
      return Matches.without(want, MatchState.REFUSED, "left unconnected by " + choice.by());
    }
    if (choice.peers().size() > 1 && want.port().arity() != Arity.MANY) {
      return Matches.without(want, MatchState.REFUSED,
          MatchSentences.need(want) + ", one connection only; " + choice.by()
              + " names " + choice.peers().size());
    }
    return result(choice.peers().stream().map(this::peer).toList());
  }

  private Match result(List<Peer> peers) {
    List<SourceId> connected = peers.stream().filter(p -> is(p, MatchState.CONNECTED)).map(Peer::id).toList();
    List<String> reasons = new ArrayList<>(peers.stream().map(Peer::reason).filter(r -> !r.isEmpty()).toList());
    if (!connected.isEmpty()) {
      reasons.addFirst("named by " + choice.by());
      String reason = String.join("; ", reasons);
      return want.chooses() ? Matches.offered(want, connected, reason) : Matches.connected(want, connected, reason);
    }
    boolean hope = peers.stream().anyMatch(p -> is(p, MatchState.PENDING));
    return Matches.without(want, hope ? MatchState.PENDING : MatchState.REFUSED, String.join("; ", reasons));
  }

  private static boolean is(Peer peer, MatchState state) {
    return peer.state() == state;
  }

  private Peer peer(SourceId id) {
    Optional<Have> have = haves.stream()
        .filter(h -> h.id().equals(id) && h.port().kind() == want.port().kind()).findFirst();
    return have.map(this::typed).orElseGet(() -> absent(id));
  }

  private Peer typed(Have have) {
    return Legal.connection(want.port(), have.port())
        ? new Peer(have.id(), MatchState.CONNECTED, "")
        : new Peer(have.id(), MatchState.REFUSED,
            MatchSentences.need(want) + "; " + have.id() + ", named by " + choice.by()
                + ", is " + have.port().typeName());
  }

  private Peer absent(SourceId id) {
    Optional<Supplier> supplier =
        suppliers.stream().filter(s -> s.component().equals(id.component())).findFirst();
    if (supplier.isEmpty()) {
      String known = suppliers.stream().map(Supplier::component).collect(Collectors.joining(", "));
      return new Peer(id, MatchState.REFUSED, "there is no robot interface '" + id.component() + "', named by "
          + choice.by() + "; there are: " + known);
    }
    String sofar = supplier.get().settled()
        ? MatchSentences.offer(id.component(), want.port().kind(), haves)
        : id.component() + " " + supplier.get().status();
    return new Peer(id, MatchState.PENDING, MatchSentences.need(want) + "; " + id + ", named by " + choice.by()
        + ", is not there; " + sofar);
  }
}
