package org.robotui.message.topic;

import java.util.Queue;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.function.Consumer;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.net.log.LogThrottle;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** What a server says beside messages: remembered until a session takes it. Safe for all threads. */
public final class ServerNotices {
  private static final Logger LOG = LoggerFactory.getLogger(ServerNotices.class);
  private static final int MOST_SAID = 100;

  private final String server;
  private final LogThrottle throttle = new LogThrottle();
  private final Queue<LogEntry> said = new ArrayBlockingQueue<>(MOST_SAID);

  /**
   * Nothing was said yet.
   *
   * @param server names it in what users read
   */
  public ServerNotices(String server) {
    this.server = server;
  }

  /**
   * A message came that cannot be read, which is logged, but not every time.
   *
   * @param reason what is wrong with it, and with whose
   */
  public void unreadable(String reason) {
    if (throttle.admit()) {
      LOG.warn("{} ({} such messages so far)", reason, throttle.count());
    }
  }

  /**
   * The server told something to its users. Where a hundred such words wait, it is lost.
   *
   * @param severity how bad it is
   * @param message what it said
   */
  public void said(Severity severity, String message) {
    said.offer(new LogEntry(severity, server, message, ""));
  }

  /**
   * Takes what was said since this was called last.
   *
   * @param taker gets it in the order in which it was said
   */
  public void take(Consumer<LogEntry> taker) {
    for (LogEntry next = said.poll(); next != null; next = said.poll()) {
      taker.accept(next);
    }
  }
}
