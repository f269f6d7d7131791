package org.robotui.api.replay;

import java.util.Optional;
import org.robotui.api.port.RawMessage;
import org.robotui.data.Data;
import org.robotui.data.Stamp;

/**
 * A value of a recording, as it is published when the recording is played.
 *
 * @param port the name of the port by which it is published
 * @param value the value
 * @param time when it was recorded, nanoseconds since 1970
 * @param stamp when it was measured, by the robot's clock; none where the message carries none
 * @param raw the message as it was recorded; its bytes are those of the file's chunk, so that who keeps it keeps that
 */
public record RecordedValue(String port, Data value, long time, Optional<Stamp> stamp, Optional<RawMessage> raw) {
  /** A stamp that is farther away from when it was recorded, in nanoseconds, is of another clock. */
  private static final long OTHER_CLOCK = 10_000_000_000L;

  /**
   * When it was true: its stamp, unless that is of another clock than the recording.
   *
   * @return nanoseconds since 1970, of the recording
   */
  public long placed() {
    return stamp.map(Stamp::nanos).filter(nanos -> Math.abs(nanos - time) < OTHER_CLOCK).orElse(time);
  }
}
