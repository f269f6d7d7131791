package org.robotui.recording.internal.chunk;

import java.util.Comparator;
import java.util.Optional;
import java.util.PriorityQueue;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingCursor;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingInterval;

/**
 * Brings the messages of chunks whose times overlap into one order. It keeps a place in each of them, and the bytes of
 * one: the others stay in the cache as long as they fit.
 */
final class MergingCursor implements RecordingCursor {

  /** Where it stands in a chunk, the place of the chunk being its order in the file for messages of one time. */
  private record Head(long time, ChunkRef chunk, int ordinal) {}

  private final TimeOrder order;
  private final ChunkCache cache;
  private final ChannelFilter filter;
  private final RecordingInterval interval;
  private final PriorityQueue<Head> heads = new PriorityQueue<>(
      Comparator.comparingLong(Head::time).thenComparingLong(head -> head.chunk().offset()));
  private int next;
  private ChunkRef at;
  private LoadedChunk loaded;

  MergingCursor(TimeOrder order, ChunkCache cache, ChannelFilter filter, RecordingInterval interval) {
    this.order = order;
    this.cache = cache;
    this.filter = filter;
    this.interval = interval;
    next = order.from(interval.start());
  }

  @Override
  public Optional<RecordedMessage> next() throws RecordingException {
    while (next < order.size() && mayBeNext(order.get(next))) {
      open(order.get(next++));
    }
    Head head = heads.poll();
    if (head == null) {
      return Optional.empty();
    }
    LoadedChunk chunk = chunk(head.chunk());
    goOn(chunk, head.chunk(), head.ordinal() + 1);
    return Optional.of(chunk.message(head.ordinal(), filter.channel(chunk.channel(head.ordinal()))));
  }

  private boolean mayBeNext(ChunkRef chunk) {
    Head head = heads.peek();
    return head == null ? chunk.start() <= interval.end() : chunk.start() <= head.time();
  }

  private void open(ChunkRef chunk) throws RecordingException {
    if (chunk.end() >= interval.start() && filter.wants(chunk)) {
      LoadedChunk opened = chunk(chunk);
      goOn(opened, chunk, opened.firstAt(interval.start()));
    }
  }

  /** Stands at the next message in this chunk that is wanted. */
  private void goOn(LoadedChunk chunk, ChunkRef ref, int from) {
    int ordinal = from;
    while (ordinal < chunk.size() && !filter.wants(chunk.channel(ordinal))) {
      ordinal++;
    }
    if (ordinal < chunk.size() && chunk.logTime(ordinal) <= interval.end()) {
      heads.add(new Head(chunk.logTime(ordinal), ref, ordinal));
    }
  }

  private LoadedChunk chunk(ChunkRef ref) throws RecordingException {
    if (ref != at) {
      loaded = cache.get(ref);
      at = ref;
    }
    return loaded;
  }
}
