package org.robotui.core.internal.match;

import java.util.List;
import java.util.stream.Collectors;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;

/** A port of which nobody said where to connect it: by its type, and where several fit, by its name. */
record AutomaticMatch(Want want, List<Have> haves, List<Supplier> suppliers) {
  Match match() {
    List<Have> fitting = haves.stream().filter(h -> Legal.connection(want.port(), h.port())).toList();
    if (fitting.isEmpty()) {
      return none();
    }
    if (want.chooses()) {
      return Matches.offered(want, ids(fitting), "the view chooses among " + fitting.size());
    }
    if (want.port().arity() == Arity.MANY) {
      return Matches.connected(want, ids(fitting), "every port of type " + want.port().typeName());
    }
    return fitting.size() == 1 ? connect(fitting, "the only port of type " + want.port().typeName()) : oneOf(fitting);
  }

  private Match oneOf(List<Have> fitting) {
    List<Have> named = nearest(fitting.stream().filter(this::hasMyName).toList());
    return named.size() == 1
        ? connect(named, "of " + fitting.size() + " ports of this type, the one named '" + want.port().name() + "'")
        : ambiguous(fitting, named.isEmpty() ? fitting : named);
  }

  /**
   * Where the ports of one interface end with the name, that which is called so and nothing else stands for the others.
   */
  private List<Have> nearest(List<Have> named) {
    List<Have> whole = named.stream().filter(h -> h.port().name().equals(want.port().name())).toList();
    boolean together = named.stream().map(h -> h.id().component()).distinct().count() == 1;
    return together && whole.size() == 1 ? whole : named;
  }

  private boolean hasMyName(Have have) {
    return MatchSentences.lastSegment(have.port().name()).equals(want.port().name());
  }

  private Match connect(List<Have> one, String reason) {
    return Matches.connected(want, ids(one), reason);
  }

  private Match ambiguous(List<Have> fitting, List<Have> best) {
    String list = fitting.stream().map(h -> h.id().toString()).collect(Collectors.joining(", "));
    return Matches.ambiguous(want, ids(fitting),
        MatchSentences.need(want) + "; " + fitting.size() + " are of this type: " + list
            + ". Write under 'connect':  " + want.id() + ": " + best.getFirst().id());
  }

  private Match none() {
    List<Supplier> open = suppliers.stream().filter(s -> !s.settled()).toList();
    String optional = want.port().arity() == Arity.OPTIONAL ? "; it works without" : "";
    if (!open.isEmpty()) {
      String status = open.stream().map(s -> s.component() + " " + s.status()).collect(Collectors.joining(", "));
      return Matches.without(want, MatchState.PENDING, MatchSentences.need(want) + "; " + status + optional);
    }
    String offers = suppliers.stream()
        .map(s -> MatchSentences.offer(s.component(), want.port().kind(), haves)).collect(Collectors.joining("; "));
    String found = suppliers.isEmpty() ? "there is no robot interface"
        : want.port().kind() == PortKind.COMMAND ? unheard(offers) : offers;
    return Matches.without(want, MatchState.REFUSED, MatchSentences.need(want) + "; " + found + optional);
  }

  /** Names the remedy first: what else the robot accepts helps only who looks for a wrong type. */
  private String unheard(String offers) {
    return "no program of the robot subscribes to it: start the one that does, and it connects by itself (" + offers
        + ")";
  }

  private static List<SourceId> ids(List<Have> haves) {
    return haves.stream().map(Have::id).toList();
  }
}
