package org.robotui.api.host;

import java.util.List;
import org.robotui.api.command.Authority;
import org.robotui.api.time.RobotClock;

/** A RUIC as its views may see it. Safe for all threads; never blocks. */
public interface RuicView {
  /**
   * The name in the configuration.
   *
   * @return the name
   */
  String name();

  /**
   * How it is doing now.
   *
   * @return a snapshot
   */
  RuicSnapshot snapshot();

  /**
   * The robots that can be commanded.
   *
   * @return an authority per robot
   */
  List<Authority> authorities();

  /**
   * Its clock.
   *
   * @return the clock
   */
  RobotClock clock();

  /**
   * Connects a port of a view to a chosen peer, in place of what matching chose, and keeps the choice.
   *
   * @param port the view's port
   * @param peer a port of a robot interface that fits
   */
  void connect(org.robotui.api.port.SourceId port, org.robotui.api.port.SourceId peer);
}
