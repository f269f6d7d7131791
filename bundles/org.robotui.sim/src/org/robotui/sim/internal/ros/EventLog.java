package org.robotui.sim.internal.ros;

import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosNode;
import org.robotui.ros.msgs.rosgraph_msgs.Log;
import org.robotui.ros.msgs.std_msgs.Header;
import org.robotui.sim.internal.Event;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Writes events to {@code /rosout} and to the program's own log. For any thread. */
final class EventLog implements Consumer<Event> {
  private static final Logger LOG = LoggerFactory.getLogger(EventLog.class);

  private final String name;
  private final LongSupplier clock;
  private final AtomicLong sequence = new AtomicLong();
  private final Publisher<Log> rosout;

  /** @param clock nanoseconds, as stamps have them */
  EventLog(RosNode node, LongSupplier clock) {
    name = node.name().text();
    this.clock = clock;
    rosout = node.publisher("/rosout", Log.CODEC, PublisherOptions.latched());
  }

  @Override
  public void accept(Event event) {
    rosout.publish(new Log(
        new Header(sequence.incrementAndGet(), clock.getAsLong(), ""), level(event), name, event.text(), event.source(), "", 0, List.of()));
    switch (event.severity()) {
      case INFO -> LOG.info("{}: {}", event.source(), event.text());
      case WARN -> LOG.warn("{}: {}", event.source(), event.text());
      case ERROR -> LOG.error("{}: {}", event.source(), event.text());
    }
  }

  private static int level(Event event) {
    return switch (event.severity()) {
      case INFO -> Log.INFO;
      case WARN -> Log.WARN;
      case ERROR -> Log.ERROR;
    };
  }
}
