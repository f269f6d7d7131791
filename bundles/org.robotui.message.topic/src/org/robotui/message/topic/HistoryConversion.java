package org.robotui.message.topic;

import java.util.Optional;
import org.robotui.api.replay.RecordedValue;

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
}
