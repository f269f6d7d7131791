package org.robotui.api.host;

import java.util.List;
import java.util.Optional;
import org.robotui.api.alert.AlertBoard;
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
   * Who may command the robot that a robot interface speaks to.
   *
   * @param component id of a robot interface, as in the sources and targets of ports
   * @return the authority, or none where there is no such robot interface
   */
  Optional<Authority> authority(String component);

  /**
   * Which of its robots the user means.
   *
   * @return always the same selection
   */
  RobotSelection selection();

  /**
   * What its views noticed that somebody should see.
   *
   * @return always the same board
   */
  AlertBoard alerts();

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
