package org.robotui.core.internal.match;

import java.util.List;
import org.robotui.api.host.Match;
import org.robotui.api.port.Port;

/** Tells whether another robot interface could take the place of one, as far as its connections are used. */
public final class Exchange {
  private Exchange() {}

  /**
   * Which ports of views would lose what they use.
   *
   * @param wants ports of views
   * @param matches what they are connected to now
   * @param component the robot interface to be replaced
   * @param offered the ports that its replacement has
   * @return those for which it has nothing that fits
   */
  public static List<Want> uncovered(
      List<Want> wants, List<Match> matches, String component, List<? extends Port> offered) {
    return matches.stream()
        .filter(m -> m.peers().stream().anyMatch(p -> p.component().equals(component)))
        .flatMap(m -> wants.stream().filter(w -> w.id().equals(m.port()) && w.port().kind() == m.kind()))
        .filter(want -> offered.stream().noneMatch(port -> Legal.connection(want.port(), port)))
        .toList();
  }

  /**
   * Says that a port would lose what it uses.
   *
   * @param want the port of the view
   * @return a sentence
   */
  public static String sentence(Want want) {
    return MatchSentences.need(want) + "; the replacement has nothing that fits";
  }
}
