package org.robotui.lcm.internal.tcpq;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;

/**
 * What clients and servers of messages say to each other: a greeting, then frames. All numbers are big-endian.
 *
 * <p>Source: the behaviour of LCM's own clients and server; there is no other description.
 */
public final class Frames {

  static final int SERVER = 0x287617fa;
  static final int CLIENT = 0x287617fb;
  static final int VERSION = 0x0100;
  static final int PUBLISH = 1;
  static final int SUBSCRIBE = 2;
  static final int UNSUBSCRIBE = 3;
  /** Regular expressions of channels are longer than channels. */
  static final int MOST_NAME = 4096;

  private Frames() {}

  /** What a frame says. */
  sealed interface Frame {}

  /** A message. */
  record Message(String channel, byte[] data) implements Frame {}

  /** A client wants channels. */
  record Subscribe(String channels) implements Frame {}

  /** A client does not want them any more. */
  record Unsubscribe(String channels) implements Frame {}

  static ByteBuffer greeting(int magic) {
    return ByteBuffer.allocate(8).putInt(magic).putInt(VERSION).flip();
  }

  static ByteBuffer message(byte[] channel, ByteBuffer data) {
    return ByteBuffer.allocate(12 + channel.length + data.remaining()).putInt(PUBLISH).putInt(channel.length)
        .put(channel)
        .putInt(data.remaining()).put(data).flip();
  }

  static ByteBuffer request(int type, String channels) {
    byte[] name = channels.getBytes(StandardCharsets.UTF_8);
    return ByteBuffer.allocate(8 + name.length).putInt(type).putInt(name.length).put(name).flip();
  }

  /** Reads the greeting of the other side. */
  static void expectGreeting(DataInputStream in, int magic) throws IOException {
    int found = in.readInt();
    int version = in.readInt();
    if (found != magic) {
      throw new IOException("it speaks no LCM: its first word is 0x" + Integer.toHexString(found) + " and not 0x"
          + Integer.toHexString(magic));
    }
    if (version != VERSION) {
      throw new IOException(
          "it speaks version 0x" + Integer.toHexString(version) + " and not 0x" + Integer.toHexString(VERSION));
    }
  }

  /** Reads a frame. Memory is taken as the bytes come, not as they are announced. */
  static Frame read(DataInputStream in, int mostData) throws IOException {
    int type = in.readInt();
    if (type < PUBLISH || type > UNSUBSCRIBE) {
      throw new IOException("it sends a frame of unknown type " + type);
    }
    String name = new String(bytes(in, MOST_NAME, "a name"), StandardCharsets.UTF_8);
    return switch (type) {
      case PUBLISH -> new Message(name, bytes(in, mostData, "a message on " + name));
      case SUBSCRIBE -> new Subscribe(name);
      default -> new Unsubscribe(name);
    };
  }

  private static byte[] bytes(DataInputStream in, int most, String what) throws IOException {
    int length = in.readInt();
    if (length < 0 || length > most) {
      throw new IOException("it announces " + what + " of " + Integer.toUnsignedString(length) + " bytes, at most "
          + most + " are accepted");
    }
    byte[] bytes = in.readNBytes(length);
    if (bytes.length < length) {
      throw new EOFException(what + " was cut off: " + bytes.length + " of " + length + " bytes came");
    }
    return bytes;
  }
}
