package org.robotui.rtps.internal.endpoint;

import java.time.Duration;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.Liveliness;
import org.robotui.rtps.Qos;

/** Whether a writer keeps the times that its reader asks for. Its reader's lock guards it. */
final class WriterWatch {

  private final Liveliness kind;
  private final long deadline;
  private final long lease;
  private long written;
  private long asserted;
  private boolean alive = true;

  WriterWatch(EndpointInfo writer, Qos requested, long now) {
    kind = writer.qos().liveliness();
    deadline = nanos(requested.deadline());
    lease = nanos(writer.qos().livelinessLease());
    written = now;
    asserted = now;
  }

  private static long nanos(Duration time) {
    return Qos.infinite(time) || time.isZero() ? Timers.NEVER : time.toNanos();
  }

  /** The writer wrote. */
  void written(long now) {
    written = now;
    asserted(now);
  }

  /** Its participant says that it is alive, and by which kind of liveliness. */
  void asserted(Liveliness by, long now) {
    if (kind == by) {
      asserted(now);
    }
  }

  /** The writer says that it is alive. */
  void asserted(long now) {
    asserted = now;
    alive = true;
  }

  /** Whether the deadline has passed, once for each time that it does. */
  boolean missed(long now) {
    boolean late = deadline != Timers.NEVER && now - written >= deadline;
    written = late ? now : written;
    return late;
  }

  /** Whether it is not alive any more, once until it is again. */
  boolean died(long now) {
    boolean dead = alive && lease != Timers.NEVER && now - asserted >= lease;
    alive = alive && !dead;
    return dead;
  }

  /** When to look again. */
  long next() {
    long byDeadline = deadline == Timers.NEVER ? Timers.NEVER : written + deadline;
    return alive && lease != Timers.NEVER ? Math.min(byDeadline, asserted + lease) : byDeadline;
  }
}
