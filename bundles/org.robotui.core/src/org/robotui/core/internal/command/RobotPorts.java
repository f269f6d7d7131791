package org.robotui.core.internal.command;

import java.util.List;
import org.robotui.core.internal.config.model.SafetyConfig;
import org.robotui.core.internal.port.StreamSource;

/** What one RUIC knows of one robot, as the arbiter sees it. */
public interface RobotPorts {
  /** The command ports of its interfaces to this robot, now. */
  List<CommandTarget<?>> commands();

  /** The streams of its interfaces to this robot, now. */
  List<StreamSource<?>> streams();

  /** How the robot is kept safe. */
  SafetyConfig safety();

  /** Cancels the calls under way that command the robot. Must not block. */
  void cancelCalls();

  /** Starts the configured stop call, where there is one. Must not block. */
  void callStop();

  /** The lease or the stop has changed. Must not block. */
  void changed();

  /** Something the user should know. Must not block. */
  void alert(String message);
}
