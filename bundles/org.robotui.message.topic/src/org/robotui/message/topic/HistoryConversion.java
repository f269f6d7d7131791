package org.robotui.message.topic;

import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.replay.RecordedValue;
import org.robotui.data.Data;
import org.robotui.data.Stamp;
import org.robotui.message.data.Adapter;
import org.robotui.message.data.FrameNames;

/**
 * Makes values of recorded messages as they are made of messages that come. Safe for all threads.
 *
 * @param <M> the Java value of a message
 */
@FunctionalInterface
public interface HistoryConversion<M> {
  /**
   * Converts a message.
   *
   * @param message the message
   * @param arrival how it would have come
   * @param time when it was recorded, nanoseconds since 1970
   * @return the value; none where the message has none
   * @throws IllegalArgumentException where no robot can mean it; the message is for users
   * @throws ArithmeticException likewise
   */
  Optional<RecordedValue> convert(M message, Arrival arrival, long time);

  /**
   * As an adapter converts.
   *
   * @param <M> the Java value of a message
   * @param <D> the data type
   * @param adapter converts
   * @param port the name of the port to which values go
   * @param names names frames of the robot, and the clock of stamps
   * @return the conversion
   */
  static <M, D extends Data> HistoryConversion<M> of(Adapter<M, D> adapter, String port, Supplier<FrameNames> names) {
    return (message, arrival, time) -> {
      FrameNames frames = names.get();
      long nanos = adapter.stamp().applyAsLong(message);
      Optional<Stamp> stamp = nanos == 0 ? Optional.empty() : Optional.of(new Stamp(nanos, frames.clock()));
      return adapter.convert().apply(message, frames)
          .map(value -> new RecordedValue(port, value, time, stamp, Optional.of(arrival.raw(adapter.type(), value))));
    };
  }
}
