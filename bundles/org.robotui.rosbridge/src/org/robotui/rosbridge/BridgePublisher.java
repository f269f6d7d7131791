package org.robotui.rosbridge;

import java.time.Duration;
import java.util.Map;
import java.util.function.Consumer;
import org.robotui.rosbridge.internal.Words;
import org.robotui.web.WebLink;

/** A topic that we publish. Safe for all threads. */
public final class BridgePublisher implements AutoCloseable {

  private final WebLink link;
  private final String topic;
  private final Consumer<BridgePublisher> end;
  private volatile boolean closed;

  BridgePublisher(WebLink link, String topic, Consumer<BridgePublisher> end) {
    this.link = link;
    this.topic = topic;
    this.end = end;
  }

  String topic() {
    return topic;
  }

  /**
   * Publishes before all that waits, or not at all.
   *
   * @param fields of the message, a tree of plain values
   * @param patience how long to wait for the network to take it
   * @return whether it is on its way; if not, it never will be
   * @throws InterruptedException if the thread was interrupted
   */
  public boolean publish(Map<String, Object> fields, Duration patience) throws InterruptedException {
    return !closed && link.command(Words.of("publish", "topic", topic, "msg", fields), patience);
  }

  /** Takes it back. */
  @Override
  public void close() {
    closed = true;
    end.accept(this);
  }
}
