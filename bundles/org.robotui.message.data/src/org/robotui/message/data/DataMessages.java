package org.robotui.message.data;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.robotui.data.Data;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.RecordCodec;
import org.robotui.message.data.CommandType.Stamped;

/**
 * Data types as messages of ROS: the way back of {@link Adapters}, for what is said to the software of another robot. A
 * message that says more than its data type has zeros there.
 */
public final class DataMessages {
  private final List<Maker<?, ?>> makers =
      Stream.of(SensorMessages.all(), StateMessages.all(), CommandType.makers(), RoboframeMessages.all())
          .flatMap(List::stream).toList();

  /** Makes messages of one type of values of another. */
  record Maker<D extends Data, M extends Record>(Class<D> data, RecordCodec<M> codec, Stamped<D, M> message) {
    static <D extends Data, M extends Record> Maker<D, M> of(Class<D> data, Class<M> form, Stamped<D, M> message) {
      return new Maker<>(data, RecordCodec.of(form), message);
    }

    String type() {
      return codec.info().type();
    }

    DynamicRecord make(Data value, long stampNanos) {
      return new MessageRecord(codec.message(message.of(data.cast(value), stampNanos)));
    }
  }

  /**
   * The type of the messages that usually carry a data type.
   *
   * @param value a value
   * @return a type of ROS of two parts, or none where no message carries such values
   */
  public Optional<String> usualType(Data value) {
    return makers.stream().filter(m -> m.data().isInstance(value)).map(Maker::type).findFirst();
  }

  /**
   * A value as a message of a type.
   *
   * @param value a value
   * @param type a type of ROS of two parts
   * @param stampNanos the time of measurement, nanoseconds by the clock of who receives the message; 0 where it is not
   * known
   * @return the fields of the message, or none where the type does not carry such values
   */
  public Optional<DynamicRecord> message(Data value, String type, long stampNanos) {
    return makers.stream().filter(m -> m.data().isInstance(value) && m.type().equals(type)).findFirst()
        .map(m -> m.make(value, stampNanos));
  }
}
