package org.robotui.core.internal.match;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.host.Match;
import org.robotui.api.host.MatchState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.SourceId;

/** Decides which ports are connected. A pure function: the same question gets the same answer. */
public final class Matcher {
  private final List<Have> haves;
  private final List<Supplier> suppliers;
  private final Map<SourceId, Choice> choices;

  private Matcher(List<Have> haves, List<Supplier> suppliers, Map<SourceId, Choice> choices) {
    this.haves = haves;
    this.suppliers = suppliers;
    this.choices = choices;
  }

  /**
   * Matches.
   *
   * @param wants ports of views
   * @param haves ports of robot interfaces
   * @param suppliers the robot interfaces
   * @param choices connections that were named
   * @return one match per port of a view, in their order
   */
  public static List<Match> match(
      List<Want> wants, List<Have> haves, List<Supplier> suppliers, Map<SourceId, Choice> choices) {
    Matcher matcher = new Matcher(haves, suppliers, choices);
    List<Match> matches = wants.stream().map(matcher::match).toList();
    return matches.stream().map(match -> covered(match, matches)).toList();
  }

  /**
   * A view of several robots has a port for all of them beside that for one. What that one leaves open is then no
   * question: the port for all takes each of them. Of one robot that offers several it stays a question.
   */
  private static Match covered(Match match, List<Match> all) {
    boolean several = match.state() == MatchState.AMBIGUOUS && match.arity() == Arity.OPTIONAL
        && match.candidates().stream().map(SourceId::component).distinct().count() > 1;
    return all.stream().filter(other -> several && covers(other, match)).findFirst()
        .map(other -> Matches.covered(match, other)).orElse(match);
  }

  private static boolean covers(Match other, Match match) {
    return other.port().component().equals(match.port().component()) && other.kind() == match.kind()
        && other.arity() == Arity.MANY
        && other.typeName().equals(match.typeName()) && other.peers().containsAll(match.candidates());
  }

  private Match match(Want want) {
    return Optional.ofNullable(choices.get(want.id()))
        .map(choice -> new NamedMatch(want, choice, haves, suppliers).match())
        .orElseGet(() -> new AutomaticMatch(want, haves, suppliers).match());
  }
}
