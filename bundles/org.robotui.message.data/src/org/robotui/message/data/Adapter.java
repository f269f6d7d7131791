package org.robotui.message.data;

import java.util.Optional;
import java.util.function.ToLongFunction;
import org.robotui.data.Data;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.DynamicMessage;
import org.robotui.message.RecordCodec;

/**
 * How messages of one ROS type become data, whatever they were encoded in.
 *
 * @param <M> the Java value of a message
 * @param <D> the data type
 * @param type the ROS type
 * @param form the Java value of a message
 * @param data the data type
 * @param convert turns one into the other
 * @param stamp the time of measurement, nanoseconds; 0 where the message carries none
 */
public record Adapter<M, D extends Data>(
    String type, MessageForm<M> form, Class<D> data, Convert<M, D> convert, ToLongFunction<M> stamp) {
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

  /** The same under another name. */
  Adapter<M, D> named(String other) {
    return new Adapter<>(other, form, data, convert, stamp);
  }

  /** Of messages that a record holds, which is bound to their definition. */
  static <M extends Record, D extends Data> Adapter<M, D> of(
      Class<M> message, Class<D> data, Simple<M, D> convert, ToLongFunction<M> stamp) {
    return of(RecordCodec.typeOf(message), new MessageForm.Bound<>(message, false), data, convert, stamp);
  }

  /** Of messages whose definition has grown over the years. */
  static <M extends Record, D extends Data> Adapter<M, D> ofAnyVersion(
      Class<M> message, Class<D> data, Simple<M, D> convert, ToLongFunction<M> stamp) {
    return of(RecordCodec.typeOf(message), new MessageForm.Bound<>(message, true), data, convert, stamp);
  }

  /** Of messages that no record holds. */
  static <D extends Data> Adapter<DynamicMessage, D> ofDynamic(String type, Class<D> data,
      Simple<DynamicMessage, D> convert) {
    return of(type, new MessageForm.Dynamic(), data, convert, m -> 0);
  }

  /** Of messages that are read by the names of their fields, whatever defines them. */
  static <D extends Data> Adapter<DynamicRecord, D> ofFields(String type, Class<D> data,
      Simple<NamedFields, D> convert) {
    return of(type, new MessageForm.ByFields(), data, (m, names) -> convert.apply(new NamedFields(m), names),
        m -> new NamedFields(m).nanos("timestamp"));
  }

  private static <M, D extends Data> Adapter<M, D> of(
      String type, MessageForm<M> form, Class<D> data, Simple<M, D> convert, ToLongFunction<M> stamp) {
    return new Adapter<>(type, form, data, (m, f) -> Optional.of(convert.apply(m, f)), stamp);
  }

  /** A conversion that always has a result. */
  @FunctionalInterface
  interface Simple<M, D> {
    D apply(M message, FrameNames frames);
  }
}
