package org.robotui.rfic.ros.internal.graph;

import java.util.Optional;
import org.robotui.api.RficContext;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;
import org.robotui.message.data.FrameNames;
import org.robotui.ros.NodeClock;

/** Tells core the robot's time and names the clock of stamps. */
final class SessionClock {
  private final RficContext context;
  private final NodeClock clock;
  private boolean wasSimulated;

  SessionClock(RficContext context, NodeClock clock) {
    this.context = context;
    this.clock = clock;
  }

  /** Called regularly by the one thread that follows the graph. */
  void tick() {
    boolean simulated = clock.isSimulated();
    if (simulated) {
      context.clock().simulated(clock.nowNanos());
    } else if (wasSimulated) {
      context.clock().live();
    }
    wasSimulated = simulated;
  }

  long nowNanos() {
    return clock.nowNanos();
  }

  FrameNames names() {
    return new FrameNames(context.robot(), clock.isSimulated() ? ClockKind.SIMULATED : ClockKind.ROBOT);
  }

  /** The stamp of a message; 0 is how ROS says that there is none. */
  Optional<Stamp> stamp(long nanos, FrameNames names) {
    if (nanos == 0) {
      return Optional.empty();
    }
    if (names.clock() == ClockKind.ROBOT) {
      context.clock().observed(nanos);
    }
    return Optional.of(new Stamp(nanos, names.clock()));
  }
}
