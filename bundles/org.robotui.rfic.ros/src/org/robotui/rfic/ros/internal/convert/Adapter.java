package org.robotui.rfic.ros.internal.convert;

import java.util.Optional;
import java.util.function.ToLongFunction;
import org.robotui.data.Data;
import org.robotui.ros.message.MessageCodec;

/**
 * How messages of one ROS type become data.
 *
 * @param <M> the Java value of a message
 * @param <D> the data type
 * @param type the ROS type
 * @param codec reads the messages
 * @param data the data type
 * @param convert turns one into the other
 * @param stamp the time of measurement, nanoseconds; 0 where the message carries none
 */
public record Adapter<M, D extends Data>(
    String type, MessageCodec<M> codec, Class<D> data, Convert<M, D> convert, ToLongFunction<M> stamp) {
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

  static <M, D extends Data> Adapter<M, D> of(
      String type, MessageCodec<M> codec, Class<D> data, Simple<M, D> convert, ToLongFunction<M> stamp) {
    return new Adapter<>(type, codec, data, (m, f) -> Optional.of(convert.apply(m, f)), stamp);
  }

  /** A conversion that always has a result. */
  @FunctionalInterface
  interface Simple<M, D> {
    D apply(M message, FrameNames frames);
  }
}
