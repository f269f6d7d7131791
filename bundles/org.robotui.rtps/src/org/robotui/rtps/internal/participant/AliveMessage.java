package org.robotui.rtps.internal.participant;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.Liveliness;

/**
 * What participants say of themselves so that their writers count as alive.
 *
 * <p>Source: "ParticipantMessageData" in the specification of RTPS.
 */
record AliveMessage(GuidPrefix participant, Liveliness kind) {

  private static final int HEADER = 4;
  private static final int AUTOMATIC = 1;
  private static final int MANUAL = 2;

  /** What we say. */
  static ByteBuffer automatic(GuidPrefix own) {
    ByteBuffer bytes = ByteBuffer.allocate(HEADER + GuidPrefix.BYTES + 12);
    bytes.put(new byte[]{0, 1, 0, 0}).putLong(own.high()).putInt(own.low()).putInt(AUTOMATIC);
    return bytes.order(ByteOrder.LITTLE_ENDIAN).putInt(1).rewind();
  }

  /** Reads one; empty if it is none, or about something else. */
  static Optional<AliveMessage> read(ByteBuffer payload) {
    if (payload.remaining() < HEADER + GuidPrefix.BYTES + 4) {
      return Optional.empty();
    }
    ByteBuffer from = payload.duplicate().order(ByteOrder.BIG_ENDIAN);
    from.position(from.position() + HEADER);
    GuidPrefix prefix = new GuidPrefix(from.getLong(), from.getInt());
    return switch (from.getInt()) {
      case AUTOMATIC -> Optional.of(new AliveMessage(prefix, Liveliness.AUTOMATIC));
      case MANUAL -> Optional.of(new AliveMessage(prefix, Liveliness.MANUAL_BY_PARTICIPANT));
      default -> Optional.empty();
    };
  }
}
