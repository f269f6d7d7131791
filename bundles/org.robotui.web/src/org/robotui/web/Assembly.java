package org.robotui.web;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Optional;

/**
 * Puts a message together from the parts in which it comes, within a bound: what is longer is passed over, whatever
 * follows of it. For one thread at a time.
 */
final class Assembly {

  private static final int FIRST = 1 << 12;

  private final int longest;
  private final StringBuilder text = new StringBuilder();
  private byte[] bytes = new byte[0];
  private int size;
  private boolean tooLong;

  Assembly(int longest) {
    this.longest = longest;
  }

  /** The message where this was its last part, unless it was too long. */
  Optional<String> text(CharSequence part, boolean last) {
    tooLong |= part.length() > longest - text.length();
    if (tooLong) {
      text.setLength(0);
    } else {
      text.append(part);
    }
    if (!last || tooLong) {
      return Optional.empty();
    }
    String whole = text.toString();
    text.setLength(0);
    text.trimToSize();
    return Optional.of(whole);
  }

  /** The message where this was its last part, unless it was too long. */
  Optional<ByteBuffer> binary(ByteBuffer part, boolean last) {
    int more = part.remaining();
    tooLong |= more > longest - size;
    if (tooLong) {
      bytes = new byte[0];
      size = 0;
    } else {
      room(more, last);
      part.get(bytes, size, more);
      size += more;
    }
    if (!last || tooLong) {
      return Optional.empty();
    }
    ByteBuffer whole = ByteBuffer.wrap(bytes, 0, size).slice();
    bytes = new byte[0];
    size = 0;
    return Optional.of(whole);
  }

  /** Whether the message that has just ended was too long; the next one begins. */
  boolean ended() {
    boolean was = tooLong;
    tooLong = false;
    return was;
  }

  private void room(int more, boolean last) {
    int needed = size + more;
    if (needed > bytes.length) {
      long grown = last ? needed : Math.min(longest, Math.max(Math.max(FIRST, needed), 2L * bytes.length));
      bytes = Arrays.copyOf(bytes, (int) grown);
    }
  }
}
