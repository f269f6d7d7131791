package org.robotui.sim.internal.ros;

import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.robotui.ros.RosLog;
import org.robotui.ros.RosLog.Level;
import org.robotui.ros.RosNode;
import org.robotui.sim.internal.Event;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Writes events to {@code /rosout} and to the program's own log. For any thread. */
final class EventLog implements Consumer<Event> {
  private static final Logger LOG = LoggerFactory.getLogger(EventLog.class);

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
    switch (event.severity()) {
      case INFO -> LOG.info("{}: {}", event.source(), event.text());
      case WARN -> LOG.warn("{}: {}", event.source(), event.text());
      case ERROR -> LOG.error("{}: {}", event.source(), event.text());
    }
  }

  private static Level level(Event event) {
    return switch (event.severity()) {
      case INFO -> Level.INFO;
      case WARN -> Level.WARN;
      case ERROR -> Level.ERROR;
    };
  }
}
