package org.robotui.lcm;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;

/** Keeps what it hears. */
public final class Heard implements LcmListener {

  private final List<LcmMessage> messages = new CopyOnWriteArrayList<>();

  @Override
  public void onMessage(LcmMessage message) {
    messages.add(message);
  }

  /** All so far. */
  public List<LcmMessage> messages() {
    return messages;
  }

  /** All so far as channel=text. */
  public List<String> texts() {
    return messages.stream().map(message -> message.channel() + "=" + StandardCharsets.UTF_8.decode(message.data()))
        .toList();
  }

  /** A text to publish. */
  public static ByteBuffer text(String text) {
    return ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8));
  }

  /** Bytes to publish that differ from place to place. */
  public static ByteBuffer bytes(int count, int seed) {
    byte[] bytes = new byte[count];
    for (int i = 0; i < count; i++) {
      bytes[i] = (byte) (i * 31 + i / 251 + seed);
    }
    return ByteBuffer.wrap(bytes);
  }
}
