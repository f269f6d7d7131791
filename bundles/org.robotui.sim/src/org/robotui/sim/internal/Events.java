package org.robotui.sim.internal;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Tells of events: the program's own log, and all who listen. For any thread. */
public final class Events implements Consumer<Event> {
  private static final Logger LOG = LoggerFactory.getLogger(Events.class);

  private final List<Consumer<Event>> listeners = new CopyOnWriteArrayList<>();

  /** @param listener called on the threads on which things happen */
  public void listen(Consumer<Event> listener) {
    listeners.add(listener);
  }

  @Override
  public void accept(Event event) {
    listeners.forEach(listener -> listener.accept(event));
    switch (event.severity()) {
      case INFO -> LOG.info("{}: {}", event.source(), event.text());
      case WARN -> LOG.warn("{}: {}", event.source(), event.text());
      case ERROR -> LOG.error("{}: {}", event.source(), event.text());
    }
  }
}
