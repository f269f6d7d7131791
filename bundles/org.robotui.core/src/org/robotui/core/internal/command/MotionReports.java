package org.robotui.core.internal.command;

import java.util.Collection;
import org.robotui.core.internal.port.StreamSource;
import org.robotui.data.Data;
import org.robotui.data.joint.JointCommand;
import org.robotui.data.joint.JointState;
import org.robotui.data.navigation.Odometry;

/** Whether a robot says that it moves, by what it sends anyway: nothing is asked for. */
final class MotionReports {
  /** Metres or radians per second: less is what a robot that stands measures. */
  private static final double STANDS = 0.02;

  private MotionReports() {}

  /** Whether motion of the kind that a port commands was reported after a moment of the monotonic clock. */
  static boolean since(long nanos, CommandTarget<?> target, Collection<StreamSource<?>> streams) {
    Class<? extends Data> kind = target.port().type() == JointCommand.class ? JointState.class : Odometry.class;
    return streams.stream().filter(s -> s.port().type() == kind).flatMap(s -> s.last().stream())
        .anyMatch(e -> e.receivedNanos() - nanos > 0 && moves(e.value()));
  }

  private static boolean moves(Data report) {
    return switch (report) {
      case Odometry o -> o.linear().norm() > STANDS || o.angular().norm() > STANDS;
      case JointState s -> s.joints().stream().anyMatch(j -> Math.abs(j.velocity()) > STANDS);
      default -> false;
    };
  }
}
