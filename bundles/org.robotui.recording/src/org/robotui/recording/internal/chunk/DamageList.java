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

  public synchronized List<RecordingDamage> all() {
    return damages.stream().sorted(Comparator.comparingLong(RecordingDamage::offset)).toList();
  }
}
