package org.robotui.uic.plot.internal.model;

import org.robotui.api.port.Envelope;
import org.robotui.data.Data;
import org.robotui.data.record.DataRecord;
import org.robotui.data.record.DynamicRecord;

/** The two ways to address the fields of a value. */
public final class Records {
  private Records() {}

  /** By the names of our data records. */
  public static DynamicRecord data(Envelope<? extends Data> envelope) {
    return DataRecord.of(envelope.value());
  }

  /** By the robot's own names; decoded when it is asked for. */
  public static DynamicRecord own(Envelope<? extends Data> envelope) {
    return envelope.record();
  }
}
