package org.robotui.roboframe.internal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.robotui.roboframe.wire.BoardKey;
import org.robotui.roboframe.wire.BrokerFraming;
import org.robotui.roboframe.wire.BrokerMessage;

/**
 * Reads what is in a frame. Every length is held against what is left of the frame before anything is made of it.
 *
 * @param in the frame, without its length
 */
public record BrokerReader(ByteBuffer in) {
  private static final int LONGEST_NAME = 200;
  private static final int LONGEST_DEFINITION = 1 << 16;
  private static final int MOST_MODULES = 256;

  /** The message of the frame. */
  public BrokerMessage message() throws IOException {
    int kind = in.get() & 0xff;
    if (kind >= FrameKind.values().length) {
      throw new IOException("a frame is of the kind " + kind + ", which is not known here");
    }
    return switch (FrameKind.values()[kind]) {
      case HELLO -> hello();
      case BOARD -> board();
      case VALUE -> new BrokerMessage.Value(text(LONGEST_NAME), in.getLong(), in.getLong(), rest());
      case PING -> new BrokerMessage.Ping(in.getLong());
      case PONG -> new BrokerMessage.Pong(in.getLong());
    };
  }

  private BrokerMessage hello() throws IOException {
    if (in.getInt() != FrameKind.MAGIC) {
      throw new IOException("this is no RoboFrame application");
    }
    int version = in.getShort() & 0xffff;
    if (version != BrokerFraming.VERSION) {
      throw new IOException("the application speaks version " + version + " of the wire, here it is "
          + BrokerFraming.VERSION);
    }
    return new BrokerMessage.Hello(version, text(LONGEST_NAME));
  }

  private BrokerMessage board() throws IOException {
    int count = bounded(in.getInt(), BrokerFraming.MOST_KEYS, "keys");
    List<BoardKey> keys = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      keys.add(new BoardKey(text(LONGEST_NAME), text(LONGEST_NAME), text(LONGEST_NAME), text(LONGEST_DEFINITION),
          names(), names()));
    }
    return new BrokerMessage.Board(keys);
  }

  private List<String> names() throws IOException {
    int count = bounded(in.getInt(), MOST_MODULES, "modules");
    List<String> names = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      names.add(text(LONGEST_NAME));
    }
    return names;
  }

  private String text(int longest) throws IOException {
    int length = bounded(in.getInt(), Math.min(longest, in.remaining()), "characters of a text");
    byte[] bytes = new byte[length];
    in.get(bytes);
    return new String(bytes, StandardCharsets.UTF_8);
  }

  private ByteBuffer rest() {
    ByteBuffer rest = in.slice().order(in.order());
    in.position(in.limit());
    return rest;
  }

  private static int bounded(int count, int most, String what) throws IOException {
    if (count < 0 || count > most) {
      throw new IOException("a frame says that it has " + Integer.toUnsignedString(count) + " " + what + "; at most "
          + most + " are taken there");
    }
    return count;
  }
}
