package org.robotui.sim.internal.ros;

import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.robotui.ros.RosLog.Level;
import org.robotui.ros.RosLog;
import org.robotui.ros.RosNode;
import org.robotui.sim.internal.Event;

/** Writes events to {@code /rosout}. For any thread. */
final class EventLog implements Consumer<Event> {
  private final LongSupplier clock;
  private final RosLog rosout;

  /** @param clock nanoseconds, as stamps have them */
  EventLog(RosNode node, LongSupplier clock) {
    this.clock = clock;
    rosout = RosLog.open(node);
  }

  @Override
  public void accept(Event event) {
    rosout.write(level(event), event.source(), event.text(), clock.getAsLong());
  }

  private static Level level(Event event) {
    return switch (event.severity()) {
      case INFO -> Level.INFO;
      case WARN -> Level.WARN;
      case ERROR -> Level.ERROR;
    };
  }
}
