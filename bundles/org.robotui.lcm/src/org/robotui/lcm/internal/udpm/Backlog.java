package org.robotui.lcm.internal.udpm;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/**
 * Datagrams between the thread that takes them from the kernel, which does nothing else, and the one that makes
 * messages of them. It takes up bursts for which the kernel's buffer is too small. Its memory grows with what waits, in
 * segments that are used again, up to a bound; then the datagrams wait in the kernel, and in the end are lost there.
 */
final class Backlog {

  private static final int SEGMENT = 1 << 20;
  private static final int ROOM = Wire.MOST_DATAGRAM + 1;

  private final int mostSegments;
  private final Deque<Entry> waiting = new ArrayDeque<>();
  private final Deque<Segment> free = new ArrayDeque<>();
  private Segment filling = new Segment();
  private int segments = 1;
  private Optional<IOException> end = Optional.empty();

  /** Memory that is filled from its beginning, and used again once nothing of it waits. */
  private static final class Segment {
    private final ByteBuffer bytes = ByteBuffer.allocateDirect(SEGMENT);
    private int used;
    private int waiting;

    boolean hasRoom() {
      return SEGMENT - used >= ROOM;
    }
  }

  /**
   * A datagram.
   *
   * @param from who sent it
   * @param bytes valid until the entry is done
   * @param received when, {@link System#nanoTime}
   * @param segment where the bytes are
   */
  record Entry(InetSocketAddress from, ByteBuffer bytes, long received, Segment segment) {}

  /** Holds at most so many bytes, but always some datagrams. */
  Backlog(long mostBytes) {
    this.mostSegments = (int) Math.max(2, mostBytes / SEGMENT);
  }

  /** Room for the next datagram; waits where all is full. For the thread that receives. */
  synchronized ByteBuffer room() throws IOException, InterruptedException {
    while (true) {
      throwEnd();
      if (filling.waiting == 0) {
        filling.used = 0; // here nothing is being put into it
      }
      if (filling.hasRoom()) {
        return filling.bytes.slice(filling.used, ROOM);
      }
      if (!free.isEmpty()) {
        filling = free.removeFirst();
      } else if (segments < mostSegments) {
        filling = new Segment();
        segments++;
      } else {
        wait();
      }
    }
  }

  /** How many bytes may still be put into it. */
  synchronized long free() {
    long left = (long) SEGMENT - ROOM - (filling.waiting == 0 ? 0 : filling.used);
    return (long) (mostSegments - segments + free.size()) * (SEGMENT - ROOM) + Math.max(0, left);
  }

  /** The datagram that was put into the room is complete: from its beginning to the position. */
  synchronized void add(InetSocketAddress from, ByteBuffer room, long received) {
    int size = room.position();
    waiting.addLast(new Entry(from, room.flip(), received, filling));
    filling.used += size;
    filling.waiting++;
    if (waiting.size() == 1) {
      notifyAll();
    }
  }

  /** The next datagram; waits for one. For the thread that makes messages. */
  synchronized Entry take() throws IOException, InterruptedException {
    while (waiting.isEmpty()) {
      throwEnd();
      wait();
    }
    return waiting.removeFirst();
  }

  /** The bytes of a datagram are not needed any more. */
  synchronized void done(Entry entry) {
    Segment segment = entry.segment();
    if (--segment.waiting == 0) {
      if (segment != filling) {
        segment.used = 0;
        free.addFirst(segment);
      }
      notifyAll();
    }
  }

  /** Nobody wants what waits. */
  synchronized void discard() {
    waiting.clear();
    end(new IOException("closed"));
  }

  /** Nothing more will come; what waits can still be taken. */
  synchronized void end(IOException reason) {
    if (end.isEmpty()) {
      end = Optional.of(reason);
    }
    notifyAll();
  }

  private void throwEnd() throws IOException {
    if (end.isPresent()) {
      throw new IOException(end.get().getMessage(), end.get());
    }
  }
}
