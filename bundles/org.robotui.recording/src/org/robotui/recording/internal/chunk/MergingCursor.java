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
  private static final class Head {
    private final ChunkRef chunk;
    private int ordinal;
    private long time;

    Head(ChunkRef chunk) {
      this.chunk = chunk;
    }

    long time() {
      return time;
    }

    long place() {
      return chunk.offset();
    }
  }

  private final TimeOrder order;
  private final ChunkCache cache;
  private final ChannelFilter filter;
  private final RecordingInterval interval;
  private final PriorityQueue<Head> heads = new PriorityQueue<>(
      Comparator.comparingLong(Head::time).thenComparingLong(Head::place));
  private int next;
  private boolean goesOn;
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
    Head head = heads.peek();
    if (head == null) {
      return Optional.empty();
    }
    LoadedChunk chunk = chunk(head.chunk);
    int ordinal = head.ordinal;
    boolean alone = heads.size() == 1;
    if (!alone) {
      heads.poll();
    }
    boolean more = goOn(chunk, head, ordinal + 1);
    if (more && !alone) {
      heads.add(head);
    } else if (!more && alone) {
      heads.poll();
    }
    return Optional.of(chunk.message(ordinal, filter.channel(chunk.channel(ordinal))));
  }

  private boolean mayBeNext(ChunkRef chunk) {
    Head head = heads.peek();
    return chunk.start() <= (head == null ? interval.end() : head.time);
  }

  private void open(ChunkRef chunk) throws RecordingException {
    if (isWanted(chunk)) {
      LoadedChunk opened = chunk(chunk);
      Head head = new Head(chunk);
      if (goOn(opened, head, opened.firstAt(interval.start()))) {
        heads.add(head);
      }
      readAhead();
    }
  }

  private boolean isWanted(ChunkRef chunk) {
    return chunk.end() >= interval.start() && filter.wants(chunk);
  }

  /** Who has asked for a second chunk will ask for more: the next one is read meanwhile. */
  private void readAhead() {
    int place = next;
    while (goesOn && place < order.size() && !isWanted(order.get(place))) {
      place++;
    }
    if (goesOn && place < order.size() && order.get(place).start() <= interval.end()) {
      cache.ahead(order.get(place));
    }
    goesOn = true;
  }

  /** Stands at the next message in this chunk that is wanted. Returns whether there is one. */
  private boolean goOn(LoadedChunk chunk, Head head, int from) {
    int ordinal = from;
    while (ordinal < chunk.size() && !filter.wants(chunk.channel(ordinal))) {
      ordinal++;
    }
    if (ordinal >= chunk.size() || chunk.logTime(ordinal) > interval.end()) {
      return false;
    }
    head.ordinal = ordinal;
    head.time = chunk.logTime(ordinal);
    return true;
  }

  private LoadedChunk chunk(ChunkRef ref) throws RecordingException {
    if (ref != at) {
      loaded = cache.get(ref);
      at = ref;
    }
    return loaded;
  }
}
