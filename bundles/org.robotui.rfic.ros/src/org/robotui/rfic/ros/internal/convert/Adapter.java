package org.robotui.rfic.ros.internal.convert;

import java.util.Optional;
import java.util.function.Supplier;
import java.util.function.ToLongFunction;
import org.robotui.data.Data;
import org.robotui.message.MessageCodec;
import org.robotui.message.RecordCodec;

/**
 * How messages of one ROS type become data.
 *
 * @param <M> the Java value of a message
 * @param <D> the data type
 * @param type the ROS type
 * @param reader makes what reads the messages, when the first robot sends some
 * @param data the data type
 * @param convert turns one into the other
 * @param stamp the time of measurement, nanoseconds; 0 where the message carries none
 */
public record Adapter<M, D extends Data>(
    String type, Supplier<MessageCodec<M>> reader, Class<D> data, Convert<M, D> convert, ToLongFunction<M> stamp) {
  /**
   * Turns a message into data.
   *
   * @param <M> the Java value of a message
   * @param <D> the data type
   */
  @FunctionalInterface
  public interface Convert<M, D> {
    /**
     * Converts.
     *
     * @param message the message
     * @param frames names frames of the robot
     * @return the value, or none where the message says nothing
     * @throws IllegalArgumentException where the message is not what it should be
     */
    Optional<D> apply(M message, FrameNames frames);
  }

  /** Of messages that a record holds, which is bound to their definition. */
  static <M extends Record, D extends Data> Adapter<M, D> of(
      Class<M> message, Class<D> data, Simple<M, D> convert, ToLongFunction<M> stamp) {
    return of(RecordCodec.typeOf(message), () -> RecordCodec.of(message), data, convert, stamp);
  }

  static <M, D extends Data> Adapter<M, D> of(
      String type, Supplier<MessageCodec<M>> reader, Class<D> data, Simple<M, D> convert, ToLongFunction<M> stamp) {
    return new Adapter<>(type, reader, data, (m, f) -> Optional.of(convert.apply(m, f)), stamp);
  }

  /**
   * What reads the messages.
   *
   * @return the codec
   */
  public MessageCodec<M> codec() {
    return reader.get();
  }

  /** A conversion that always has a result. */
  @FunctionalInterface
  interface Simple<M, D> {
    D apply(M message, FrameNames frames);
  }
}
