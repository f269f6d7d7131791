package org.robotui.uic.map.internal.model;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.robotui.api.command.Authority;
import org.robotui.api.host.RuicView;
import org.robotui.api.port.SourceId;

/** The robots of the map, each with a number that gives it its colour. Any thread. */
public final class Team {
  private final RuicView ruic;
  private final Map<String, Integer> numbers = new LinkedHashMap<>();

  /** Those of a RUIC. */
  public Team(RuicView ruic) {
    this.ruic = ruic;
    ruic.authorities().stream().map(Authority::robot).forEach(robot -> numbers.putIfAbsent(robot, numbers.size()));
  }

  /** Whether there are several. */
  public boolean isSeveral() {
    return numbers.size() > 1;
  }

  /** The number of a robot; those that nobody configured come last. */
  public int number(String robot) {
    return numbers.getOrDefault(robot, numbers.size());
  }

  /** The robot that a source belongs to. */
  public Optional<String> robot(SourceId source) {
    return ruic.authority(source.component()).map(Authority::robot);
  }

  /**
   * The colour of what a source gives; none where there is one robot only, whose things have colours by what they are.
   */
  OptionalInt tint(SourceId source) {
    return isSeveral() ? OptionalInt.of(robot(source).map(this::number).orElse(numbers.size())) : OptionalInt.empty();
  }

  /** Which robots the user means. */
  public Set<String> selected() {
    return ruic.selection().robots();
  }

  /** Has other robots meant. */
  public void select(Set<String> robots) {
    ruic.selection().set(robots);
  }
}
