package org.robotui.yarp.internal;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import java.util.OptionalInt;
import org.robotui.yarp.bottle.YarpFormatException;
import org.robotui.yarp.wire.YarpFraming;
import org.robotui.yarp.wire.YarpMessage;

/**
 * Puts messages together that come in datagrams. One message is open at a time and never takes more memory than has
 * come of it; a datagram that does not follow the last one ends it, as nothing else tells to which message it belongs.
 */
public final class DatagramAssembly {
  private final ByteArrayOutputStream open = new ByteArrayOutputStream();
  private OptionalInt length = OptionalInt.empty();
  private int next;

  /**
   * What a datagram led to.
   *
   * @param message that is complete with it
   * @param lost what was lost before it or with it, for a user to read
   */
  public record Taken(Optional<YarpMessage> message, Optional<String> lost) {}

  /** Takes a datagram, which has an array. */
  public Taken take(ByteBuffer datagram) {
    ByteBuffer in = datagram.order(ByteOrder.LITTLE_ENDIAN);
    if (in.remaining() < DatagramPieces.HEAD) {
      return lost("a datagram of " + in.remaining() + " bytes; its head alone has " + DatagramPieces.HEAD);
    }
    int sum = in.getInt();
    int place = in.getInt();
    if (place == DatagramPieces.NOWHERE) {
      return new Taken(Optional.empty(), Optional.empty());
    }
    if ((int) DatagramPieces.sum(in.duplicate()) != sum) {
      return lost("a datagram was damaged on its way");
    }
    if (place != next && place != 0) {
      return lost("datagram " + place + " of a message came in place of " + next);
    }
    Optional<String> before = place == next ? Optional.empty()
        : Optional.of("a message ended early, after " + next
            + " datagrams");
    if (before.isPresent()) {
      reset();
    }
    open.write(in.array(), in.arrayOffset() + in.position(), in.remaining());
    next++;
    try {
      return new Taken(complete(), before);
    } catch (IOException e) {
      return lost(String.valueOf(e.getMessage()));
    }
  }

  private Optional<YarpMessage> complete() throws IOException {
    if (length.isEmpty()) {
      length = YarpFraming.length(open.toByteArray());
    }
    if (length.isEmpty() || open.size() < length.getAsInt()) {
      return Optional.empty();
    }
    if (open.size() > length.getAsInt()) {
      throw new YarpFormatException("datagrams hold more than the message of " + length.getAsInt() + " bytes");
    }
    YarpMessage message = YarpFraming.read(new ByteArrayInputStream(open.toByteArray()));
    reset();
    return Optional.of(message);
  }

  private Taken lost(String reason) {
    reset();
    return new Taken(Optional.empty(), Optional.of(reason));
  }

  private void reset() {
    open.reset();
    length = OptionalInt.empty();
    next = 0;
  }
}
