package org.robotui.core.internal.match;

import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.Port;
import org.robotui.api.port.StreamPort;

/** Which ports may be connected: what is produced must be, or extend, what is accepted. */
final class Legal {
  private Legal() {}

  /** Whether a view's port may be connected with a robot interface's. */
  static boolean connection(Port view, Port robot) {
    return switch (view) {
      case StreamPort<?> v -> robot instanceof StreamPort<?> r && v.type().isAssignableFrom(r.type());
      case CommandPort<?> v -> robot instanceof CommandPort<?> r && r.type().isAssignableFrom(v.type());
      case CallPort<?, ?> v -> robot instanceof CallPort<?, ?> r && call(v, r);
      case BrowsePort v -> robot instanceof BrowsePort;
    };
  }

  private static boolean call(CallPort<?, ?> view, CallPort<?, ?> robot) {
    return robot.request().isAssignableFrom(view.request()) && view.reply().isAssignableFrom(robot.reply());
  }
}
