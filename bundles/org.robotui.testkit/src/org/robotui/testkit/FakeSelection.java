package org.robotui.testkit;

import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.Set;
import org.robotui.api.host.RobotSelection;

/** A selection of robots that a test can read. */
public final class FakeSelection implements RobotSelection {
  private volatile Set<String> robots = Set.of();

  /** With nothing selected. */
  public FakeSelection() {}

  @Override
  public Set<String> robots() {
    return robots;
  }

  @Override
  public void set(Set<String> selected) {
    robots = Collections.unmodifiableSet(new LinkedHashSet<>(selected));
  }
}
