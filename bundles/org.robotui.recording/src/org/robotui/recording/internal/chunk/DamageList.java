package org.robotui.recording.internal.chunk;

import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.robotui.recording.RecordingDamage;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** What could not be read, each once however often it is met. Any thread may use it. */
public final class DamageList {

  private static final Logger LOG = LoggerFactory.getLogger(DamageList.class);
  private static final int MOST = 1000;

  private final Set<RecordingDamage> damages = new LinkedHashSet<>();

  public synchronized void add(long offset, String problem) {
    RecordingDamage damage = new RecordingDamage(offset, problem);
    if (damages.size() < MOST && damages.add(damage)) {
      LOG.debug("A recording is damaged: {}", damage);
    }
  }

  /** Tells of a chunk that reaches beyond the times which the index has of it. */
  public void tellOtherTimes(ChunkRef ref, LoadedChunk chunk) {
    if (chunk.size() > 0 && (chunk.logTime(0) < ref.start() || chunk.logTime(chunk.size() - 1) > ref.end())) {
      add(ref.offset(), "a chunk has messages of other times than the index says: their order is not sure");
    }
  }

  public synchronized List<RecordingDamage> all() {
    return damages.stream().sorted(Comparator.comparingLong(RecordingDamage::offset)).toList();
  }
}
