package org.robotui.api.command;

import java.time.Duration;
import java.util.List;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;

/**
 * The view's end of a command port. All commands pass the arbiter of the robot.
 *
 * @param <T> the type of the commands
 */
public interface Output<T extends Data> {
  /**
   * Gives a command. Returns at once; called from any thread. A command that keeps something moving must be renewed
   * within its validity, else the arbiter stops the motion.
   *
   * @param command the command
   * @param validFor how long it is true; nothing is sent later
   * @return whether the arbiter took it
   */
  CommandOutcome send(T command, Duration validFor);

  /**
   * Gives a command to one of several targets, else as {@link #send(Data, Duration)}.
   *
   * @param target one of {@link #targets()}
   * @param command the command
   * @param validFor how long it is true; nothing is sent later
   * @return whether the arbiter of its robot took it
   */
  CommandOutcome send(SourceId target, T command, Duration validFor);

  /** Ends a motion now: its zero is sent once if this output moved something. Always possible. */
  void release();

  /**
   * Where the commands go.
   *
   * @return the connected ports
   */
  List<SourceId> targets();

  /**
   * Whether there is somebody to command, and if not: why.
   *
   * @return live where connected
   */
  InputState state();

  /**
   * The authority over the robot to which this output leads.
   *
   * @return its lease and stop
   */
  Authority authority();
}
