package org.robotui.api.host;

import java.util.List;
import java.util.Optional;
import org.robotui.api.alert.AlertBoard;
import org.robotui.api.command.Authority;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.ShowChoice;
import org.robotui.api.show.Subject;
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
   * What can be done with something that the user points at: what the types of views that are installed declare. May
   * look at every port.
   *
   * @param subject a port, a frame or a node of this RUIC
   * @return an entry for each view that could show it, and one for each type of which no view is open, which opens one;
   * those that can be done first, then by label
   */
  List<ShowChoice> showChoices(Subject subject);

  /**
   * Has a view show something, and the application bring that view to the front. One that is not open is opened before.
   * Does nothing where the view has gone.
   *
   * @param choice one of {@link #showChoices} that can be done
   * @param subject what to show
   */
  void show(ShowChoice choice, Subject subject);

  /**
   * The newest value of a stream.
   *
   * @param port a port of a robot interface
   * @return the value, merged for keyed types; none before the first, where nobody has asked the robot for it, or where
   * there is no such stream
   */
  Optional<Envelope<?>> newest(SourceId port);

  /**
   * The newest command that went out to a robot, whoever gave it, as its limits have it.
   *
   * @param port a command port of a robot interface
   * @return the command; none before the first, or where there is no such port
   */
  default Optional<Envelope<?>> sent(SourceId port) {
    return Optional.empty();
  }

  /**
   * Has transforms forgotten, but for fixed ones, and what its views collected over time, as when the clock jumps back.
   * What robots say but once, such as a map, stays.
   */
  void reset();

  /**
   * Connects a port of a view to a chosen peer, in place of what matching chose, and keeps the choice.
   *
   * @param port the view's port
   * @param peer a port of a robot interface that fits
   */
  void connect(SourceId port, SourceId peer);
}
