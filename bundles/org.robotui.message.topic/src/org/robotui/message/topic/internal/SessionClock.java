package org.robotui.message.topic.internal;

import java.util.Optional;
import org.robotui.api.RficContext;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;
import org.robotui.message.data.FrameNames;
import org.robotui.message.topic.TopicClient;

/** Tells core the robot's time and names the clock of stamps. */
public final class SessionClock {
  private final RficContext context;
  private final TopicClient client;
  private boolean wasSimulated;

  /**
   * Creates a clock.
   *
   * @param context is told the time
   * @param client knows it
   */
  public SessionClock(RficContext context, TopicClient client) {
    this.context = context;
    this.client = client;
  }

  /** Called regularly by the one thread that follows the graph. */
  public void tick() {
    boolean simulated = client.isSimulated();
    if (simulated) {
      context.clock().simulated(client.nowNanos());
    } else if (wasSimulated) {
      context.clock().live();
    }
    wasSimulated = simulated;
  }

  long nowNanos() {
    return client.nowNanos();
  }

  FrameNames names() {
    return new FrameNames(context.robot(), client.isSimulated() ? ClockKind.SIMULATED : ClockKind.ROBOT);
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
