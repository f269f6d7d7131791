package org.robotui.core.internal.life;

import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.Set;
import org.robotui.api.host.RobotSelection;

/** The robots of one RUIC that the user means. */
final class SelectedRobots implements RobotSelection {
  private volatile Set<String> robots = Set.of();

  @Override
  public Set<String> robots() {
    return robots;
  }

  @Override
  public void set(Set<String> selected) {
    robots = Collections.unmodifiableSet(new LinkedHashSet<>(selected));
  }
}
