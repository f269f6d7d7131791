package org.robotui.rfic.gazebo.internal.session;

import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.gazebo.GazeboListener;
import org.robotui.net.log.LogThrottle;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Remembers that something has changed, until somebody asks. Safe for all threads. */
final class NodeNews implements GazeboListener {
  private static final Logger LOG = LoggerFactory.getLogger(NodeNews.class);

  private final LogThrottle throttle = new LogThrottle();
  private final AtomicBoolean changed = new AtomicBoolean(true);

  @Override
  public void onUnreadable(String reason) {
    if (throttle.admit()) {
      LOG.warn("{} ({} such messages so far)", reason, throttle.count());
    }
  }

  @Override
  public void onGraph() {
    changed.set(true);
  }

  /** Whether there is something else than when this was asked last. */
  boolean take() {
    return changed.getAndSet(false);
  }
}
