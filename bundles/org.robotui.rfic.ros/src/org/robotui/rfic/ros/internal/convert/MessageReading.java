package org.robotui.rfic.ros.internal.convert;

import java.nio.ByteBuffer;
import java.util.function.Function;
import org.robotui.message.MessageCodec;
import org.robotui.message.MessageException;
import org.robotui.message.MessageInfo;
import org.robotui.message.MessageRegistry;
import org.robotui.message.RawCodec;
import org.robotui.message.RecordCodec;
import org.robotui.message.VersionTolerantCodec;
import org.robotui.message.data.MessageForm;
import org.robotui.message.data.MessageRecord;

/**
 * How messages of ROS 1 are received and read. One that no definition fits is the matter of its message, not of the
 * connection, so messages that no record holds are received as bytes.
 *
 * @param <R> what is received
 * @param <M> the Java value of a message
 * @param codec receives
 * @param message reads what was received; throws IllegalArgumentException where it cannot
 */
public record MessageReading<R, M>(MessageCodec<R> codec, Function<R, M> message) {
  /**
   * How messages of a form are read.
   *
   * @param <M> the Java value of a message
   * @param form the form
   * @param records reads messages that no record holds, and knows other versions of a type
   * @return the reading; a record is bound now
   */
  @SuppressWarnings("unchecked") // the messages of each form are of its own type
  public static <M> MessageReading<?, M> of(MessageForm<M> form, RecordDecoder records) {
    return switch (form) {
      case MessageForm.Bound<?> bound -> (MessageReading<?, M>) bound(bound, records.registry());
      case MessageForm.Dynamic any -> (MessageReading<?, M>) new MessageReading<>(new RawCodec(), records::decode);
      case MessageForm.ByFields any -> (MessageReading<?, M>) new MessageReading<>(new RawCodec(),
          raw -> new MessageRecord(records.decode(raw)));
    };
  }

  /**
   * Reads a message of a recording.
   *
   * @param bytes the whole message and nothing else
   * @param peer its type as it was announced
   * @return the message
   * @throws MessageException if the bytes are no message of that type
   */
  public M read(ByteBuffer bytes, MessageInfo peer) throws MessageException {
    return message.apply(codec.decode(bytes, peer));
  }

  private static <M extends Record> MessageReading<M, M> bound(MessageForm.Bound<M> bound, MessageRegistry registry) {
    RecordCodec<M> codec = RecordCodec.of(bound.type());
    return new MessageReading<>(bound.anyVersion() ? new VersionTolerantCodec<>(codec, registry) : codec,
        Function.identity());
  }
}
