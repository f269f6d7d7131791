package org.robotui.lcm.internal.udpm;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Gives up whole messages when more comes than can be taken. A message of many fragments is lost with any of them, so
 * it is let in only where there is room for all of it; what is refused is refused from its first fragment to its last,
 * and those let in come through complete.
 *
 * <p>For the thread that receives.
 */
final class Gate {

  private static final int MOST_MESSAGES = 64;
  /** Of a message whose next fragment takes longer, room is not kept. */
  private static final long PATIENCE = Duration.ofMillis(50).toNanos();

  private final long capacity;
  private final Map<Reassembly.Key, Coming> coming = new LinkedHashMap<>();
  private long kept;

  /** A message of which fragments came, and the room that is kept for the others. */
  private static final class Coming {
    private final boolean refused;
    private int fragments;
    private long kept;
    private long last;

    Coming(int fragments, long kept, boolean refused) {
      this.fragments = fragments;
      this.kept = kept;
      this.refused = refused;
    }
  }

  /** Keeps room in a backlog of so many bytes. */
  Gate(long capacity) {
    this.capacity = capacity;
  }

  /** Whether a datagram is let in where so many bytes are free. Its position stays. */
  boolean admits(InetSocketAddress from, ByteBuffer datagram, long free, long now) {
    if (datagram.remaining() < Wire.FRAGMENT_HEADER || datagram.getInt(datagram.position()) != Wire.FRAGMENT) {
      return true;
    }
    try {
      Fragment fragment = Fragment.read(datagram.duplicate());
      return admits(new Reassembly.Key(from, fragment.sequence()), fragment, datagram.remaining(), free, now);
    } catch (DatagramException e) {
      return true; // whoever makes messages of them counts it
    }
  }

  private boolean admits(Reassembly.Key key, Fragment fragment, int length, long free, long now) {
    Coming message = coming.get(key);
    if (message == null) {
      message = begin(key, fragment, free, now);
    }
    message.last = now;
    long used = Math.min(message.kept, length);
    message.kept -= used;
    kept -= used;
    if (--message.fragments == 0) {
      coming.remove(key);
      kept -= message.kept;
    }
    return !message.refused;
  }

  private Coming begin(Reassembly.Key key, Fragment fragment, long free, long now) {
    forget(key.from(), now);
    // a message that is longer than the backlog can come through as well, if it is taken while it comes
    long room = Math.min((long) fragment.size() + (long) fragment.count() * Wire.FRAGMENT_HEADER, capacity / 2);
    boolean refused = room > free - kept;
    Coming message = new Coming(fragment.count(), refused ? 0 : room, refused);
    kept += message.kept;
    coming.put(key, message);
    return message;
  }

  /** A sender's fragments come in their order: what is incomplete when its next message begins stays so. */
  private void forget(InetSocketAddress from, long now) {
    coming.entrySet().removeIf(each -> {
      boolean over =
          each.getKey().from().equals(from) || now - each.getValue().last > PATIENCE || coming.size() >= MOST_MESSAGES;
      kept -= over ? each.getValue().kept : 0;
      return over;
    });
  }
}
