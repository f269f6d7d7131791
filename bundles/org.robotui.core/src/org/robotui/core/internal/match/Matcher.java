package org.robotui.core.internal.match;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.host.Match;
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
    return wants.stream().map(matcher::match).toList();
  }

  private Match match(Want want) {
    return Optional.ofNullable(choices.get(want.id()))
        .map(choice -> new NamedMatch(want, choice, haves, suppliers).match())
        .orElseGet(() -> new AutomaticMatch(want, haves, suppliers).match());
  }
}
