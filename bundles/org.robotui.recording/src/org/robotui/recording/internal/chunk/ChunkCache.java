package org.robotui.recording.internal.chunk;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import org.robotui.recording.RecordingException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The chunks that were used last, as many as fit into a bounded memory. Any thread may use it. */
final class ChunkCache {

  private static final Logger LOG = LoggerFactory.getLogger(ChunkCache.class);
  private static final long MOST_BYTES = 64L << 20;

  private final ChunkSource source;
  private final Map<ChunkRef, LoadedChunk> chunks = new LinkedHashMap<>(16, 0.75f, true);
  private long bytes;

  ChunkCache(ChunkSource source) {
    this.source = source;
  }

  /**
   * Begins to load what will be asked for next. Plain chunks are read as soon as another thread is told of them; the
   * system reads ahead itself. Where it cannot be read, who asks is told.
   */
  void ahead(ChunkRef ref) {
    if (!source.decompresses()) {
      return;
    }
    Thread.ofVirtual().start(() -> {
      try {
        get(ref);
      } catch (RecordingException e) {
        LOG.debug("Cannot read ahead at byte {}", ref.offset(), e);
      }
    });
  }

  /** One is read at a time: two at once would need the memory of both. */
  synchronized LoadedChunk get(ChunkRef ref) throws RecordingException {
    LoadedChunk there = chunks.get(ref);
    if (there != null) {
      return there;
    }
    LoadedChunk loaded = source.load(ref);
    bytes += loaded.cost();
    for (Iterator<LoadedChunk> oldest = chunks.values().iterator(); bytes > MOST_BYTES && oldest.hasNext();) {
      bytes -= oldest.next().cost();
      oldest.remove();
    }
    chunks.put(ref, loaded);
    return loaded;
  }
}
