package org.robotui.roboframe.internal;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.robotui.message.MessageWriter;
import org.robotui.roboframe.wire.BoardKey;
import org.robotui.roboframe.wire.BrokerMessage;

/** Writes frames. */
public final class BrokerWriter {
  private BrokerWriter() {}

  /** A message with its length before it. */
  public static byte[] bytes(BrokerMessage message) {
    ByteBuffer body = body(message).view();
    ByteBuffer all = ByteBuffer.allocate(Integer.BYTES + body.remaining()).order(ByteOrder.LITTLE_ENDIAN);
    return all.putInt(body.remaining()).put(body).array();
  }

  private static MessageWriter body(BrokerMessage message) {
    MessageWriter out = new MessageWriter();
    out.u8(kind(message).ordinal());
    switch (message) {
      case BrokerMessage.Hello hello -> out.i32(FrameKind.MAGIC).i16(hello.version()).string(hello.application());
      case BrokerMessage.Board board -> {
        out.i32(board.keys().size());
        board.keys().forEach(key -> write(out, key));
      }
      case BrokerMessage.Value value -> {
        out.string(value.key()).i64(value.stampNanos()).i64(value.count());
        out.bytes(value.bytes().duplicate());
      }
      case BrokerMessage.Ping ping -> out.i64(ping.token());
      case BrokerMessage.Pong pong -> out.i64(pong.token());
    }
    return out;
  }

  private static FrameKind kind(BrokerMessage message) {
    return switch (message) {
      case BrokerMessage.Hello hello -> FrameKind.HELLO;
      case BrokerMessage.Board board -> FrameKind.BOARD;
      case BrokerMessage.Value value -> FrameKind.VALUE;
      case BrokerMessage.Ping ping -> FrameKind.PING;
      case BrokerMessage.Pong pong -> FrameKind.PONG;
    };
  }

  private static void write(MessageWriter out, BoardKey key) {
    out.string(key.name()).string(key.type()).string(key.sum()).string(key.definition());
    names(out, key.writers());
    names(out, key.readers());
  }

  private static void names(MessageWriter out, List<String> names) {
    out.i32(names.size());
    names.forEach(out::string);
  }
}
