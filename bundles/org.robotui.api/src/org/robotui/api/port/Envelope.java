package org.robotui.api.port;

import java.util.Optional;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.data.record.DataRecord;
import org.robotui.data.record.DynamicRecord;

/**
 * A value on its way.
 *
 * @param <T> the type of the value
 * @param value the value
 * @param source where it came from
 * @param sequence counts the values of that source from 0; gaps are drops
 * @param stamp when it was measured, by the source's clock; none where the message carries none
 * @param receivedNanos when it was received, {@link System#nanoTime()}; age is measured on this
 * @param raw the message as it came, where the robot interface keeps it
 */
public record Envelope<T extends Data>(
    T value, SourceId source, long sequence, Optional<Stamp> stamp, long receivedNanos, Optional<RawMessage> raw) {
  /**
   * The value with the names that the robot gives, decoded when asked.
   *
   * @return the fields of the message as it came, or of the value where the robot interface does not keep messages
   */
  public DynamicRecord record() {
    return raw.flatMap(RawMessage::record).orElseGet(() -> DataRecord.of(value));
  }

  /**
   * How old the value is.
   *
   * @param nowNanos {@link System#nanoTime()}
   * @return seconds since it was received
   */
  public double ageSeconds(long nowNanos) {
    return (nowNanos - receivedNanos) * 1e-9;
  }
}
