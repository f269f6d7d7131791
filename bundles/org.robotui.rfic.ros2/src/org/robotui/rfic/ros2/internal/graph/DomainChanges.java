package org.robotui.rfic.ros2.internal.graph;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.ros2.Ros2Context;
import org.robotui.rtps.DiscoveryListener;
import org.robotui.rtps.ParticipantInfo;

/** Notes that something has changed in a domain, and why the last participant has gone. Safe for all threads. */
final class DomainChanges implements DiscoveryListener, AutoCloseable {
  private final Ros2Context ros;
  private final AutoCloseable following;
  private final AtomicBoolean changed = new AtomicBoolean(true);
  private volatile Optional<String> lost = Optional.empty();
  private volatile boolean over;

  DomainChanges(Ros2Context ros) {
    this.ros = ros;
    this.following = ros.graph().onChange(() -> changed.set(true));
    ros.participant().discovery().addListener(this);
  }

  /** Whether something has changed since the last question. */
  boolean since() {
    return changed.getAndSet(false);
  }

  /** Why the last one has gone. */
  Optional<String> lost() {
    return lost;
  }

  /** Whether nobody looks any more. */
  boolean over() {
    return over;
  }

  @Override
  public void participantLost(ParticipantInfo participant, String reason) {
    lost = Optional.of(reason);
  }

  @Override
  public void close() {
    over = true;
    ros.participant().discovery().removeListener(this);
    try {
      following.close();
    } catch (Exception e) {
      throw new IllegalStateException("the graph is followed for ever", e);
    }
  }
}
