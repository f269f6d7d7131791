package org.robotui.guard.internal.process;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/** What a robot sent and nobody took yet. */
final class Backlog {

  /** What is between {@code taken} and the position of {@code data} waits. */
  private static final class Part {
    private final ByteBuffer data;
    private int taken;

    Part(ByteBuffer data) {
      this.data = data;
    }

    ByteBuffer waiting() {
      return data.duplicate().limit(data.position()).position(taken);
    }
  }

  private final Chunks chunks;
  private final int most;
  private final Deque<Part> parts = new ArrayDeque<>();

  Backlog(Chunks chunks, int most) {
    this.chunks = chunks;
    this.most = most;
  }

  boolean isEmpty() {
    return parts.isEmpty();
  }

  boolean isHalfFull() {
    return parts.size() > most / 2;
  }

  /** Whether something can be read, now that others may have given memory back. */
  boolean hasRoom() {
    return parts.size() < most && chunks.areLeft() || !parts.isEmpty() && parts.peekLast().data.hasRemaining();
  }

  long bytes() {
    return parts.stream().mapToLong(part -> part.waiting().remaining()).sum();
  }

  /** Reads once; answers how much that was, -1 at the end, empty where there is no room. */
  Optional<Integer> readFrom(SocketChannel source) throws IOException {
    Optional<ByteBuffer> room = room();
    if (room.isEmpty()) {
      return Optional.empty();
    }
    int count = source.read(room.get());
    if (count <= 0) {
      dropEmptyTail();
    }
    return Optional.of(count);
  }

  private Optional<ByteBuffer> room() {
    if (!parts.isEmpty() && parts.peekLast().data.hasRemaining()) {
      return Optional.of(parts.peekLast().data);
    }
    Optional<ByteBuffer> fresh = parts.size() < most ? chunks.take() : Optional.empty();
    fresh.ifPresent(chunk -> parts.addLast(new Part(chunk)));
    return fresh;
  }

  private void dropEmptyTail() {
    if (!parts.isEmpty() && !parts.peekLast().waiting().hasRemaining()) {
      chunks.give(parts.pollLast().data);
    }
  }

  /** Writes what is taken at once. */
  void writeTo(SocketChannel target) throws IOException {
    while (!parts.isEmpty()) {
      Part first = parts.peekFirst();
      first.taken += target.write(first.waiting());
      if (first.waiting().hasRemaining()) {
        return;
      }
      chunks.give(parts.pollFirst().data);
    }
  }

  void drop() {
    parts.forEach(part -> chunks.give(part.data));
    parts.clear();
  }
}
