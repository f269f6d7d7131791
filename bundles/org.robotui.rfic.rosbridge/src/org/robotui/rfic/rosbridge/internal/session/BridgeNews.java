package org.robotui.rfic.rosbridge.internal.session;

import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ArrayBlockingQueue;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.net.log.LogThrottle;
import org.robotui.rosbridge.BridgeListener;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Remembers what a bridge said of what it was told, until somebody takes it. Safe for all threads. */
final class BridgeNews implements BridgeListener {
  private static final Logger LOG = LoggerFactory.getLogger(BridgeNews.class);
  private static final int MOST_SAID = 100;

  private final String server;
  private final LogThrottle throttle = new LogThrottle();
  private final Queue<LogEntry> said = new ArrayBlockingQueue<>(MOST_SAID);

  BridgeNews(String server) {
    this.server = server;
  }

  @Override
  public void onUnreadable(String reason) {
    if (throttle.admit()) {
      LOG.warn("{} ({} such messages so far)", reason, throttle.count());
    }
  }

  @Override
  public void onStatus(String level, String message) {
    Severity severity = switch (level) {
      case "error" -> Severity.ERROR;
      case "warning" -> Severity.WARNING;
      default -> Severity.INFO;
    };
    said.offer(new LogEntry(severity, server, message, ""));
  }

  /** What it has said next, if anything. */
  Optional<LogEntry> take() {
    return Optional.ofNullable(said.poll());
  }
}
