package org.robotui.uic.team.internal.model;

import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.SourceId;
import org.robotui.ui.LinkLook;

/**
 * A robot of the team and what speaks to it.
 *
 * @param robot its name
 * @param number its place among the robots, from 0
 * @param interfaces what speaks to it; at least one
 */
record Member(String robot, int number, List<ComponentStatus> interfaces) {
  boolean has(SourceId source) {
    return interfaces.stream().anyMatch(c -> c.id().equals(source.component()));
  }

  String framework() {
    return interfaces.stream().map(ComponentStatus::type).distinct().collect(Collectors.joining(", "));
  }

  /** The interface that fares worst. */
  ComponentStatus worst() {
    return interfaces.stream().max(Comparator.comparingInt(Member::badness)).orElseThrow();
  }

  boolean isLost() {
    return badness(worst()) > 2;
  }

  private static int badness(ComponentStatus c) {
    if (c.state() == RuicState.FAILED) {
      return 5;
    }
    return c.link().map(link -> switch (link) {
      case LinkState.Connected l -> 0;
      case LinkState.Degraded l -> 1;
      case LinkState.Connecting l -> 2;
      case LinkState.Disconnected l -> 3;
      case LinkState.Failed l -> 4;
    }).orElse(0);
  }

  String linkWord() {
    return LinkLook.word(worst());
  }
}
