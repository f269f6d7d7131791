package org.robotui.uic.joints.internal.model;

import java.util.OptionalInt;
import org.robotui.api.port.SourceId;
import org.robotui.data.joint.JointState.Joint;

/** What is remembered of one joint of one source. Used by the tick only. */
final class Track {
  private static final double NANOS = 1e-9;
  private static final double SMOOTH = 0.2;
  private static final double LEAST_SILENCE = 1;
  private static final double INTERVALS = 5;

  private Joint newest;
  private long received;
  private double interval;
  private Span seen = Span.NONE;

  Track(Joint first, long receivedNanos) {
    newest = first;
    received = receivedNanos;
    seen = seen.with(first.position());
  }

  void put(Joint joint, long receivedNanos) {
    double passed = (receivedNanos - received) * NANOS;
    interval = interval == 0 ? passed : interval + SMOOTH * (passed - interval);
    newest = joint;
    received = receivedNanos;
    seen = seen.with(joint.position());
  }

  void forgetRange() {
    seen = Span.NONE.with(newest.position());
  }

  /** Whether it is silent for longer than its own rhythm lets expect, while its source goes on. */
  boolean isSilent(long sourceNanos) {
    return (sourceNanos - received) * NANOS > Math.max(LEAST_SILENCE, INTERVALS * interval);
  }

  JointRow row(SourceId source, JointOptions options, boolean stale, long now, JointRow.Fields fields,
      OptionalInt index) {
    String name = newest.name();
    return new JointRow(source, newest, options.unit(name), options.limits(name).orElse(seen),
        Math.max(0, (now - received) * NANOS), stale, fields, index);
  }
}
