package org.robotui.core.internal.time;

import java.util.List;
import java.util.Map;
import org.robotui.api.frame.FrameLink.Rival;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.net.collection.LruMap;

/** Who said where one frame is, and when the last ones came. Safe for all threads. */
final class FrameVoices {
  private static final int KEPT = 16;
  private static final int MOST_VOICES = 4;
  private static final long LATELY_NANOS = 10_000_000_000L;
  private static final double NANO = 1e-9;
  private static final double PATIENCE_SECONDS = 1;
  private static final double PATIENCE_PERIODS = 5;

  /** One who says it: since when without a pause, and when last. */
  private record Voice(long first, long last) {}

  private final long[] times = new long[KEPT];
  private final Map<Rival, Voice> voices = new LruMap<>(MOST_VOICES);
  private long count;
  private boolean fixed;
  private ClockKind clock = ClockKind.ROBOT;

  synchronized void say(FrameId parent, String authority, boolean forAllTimes, ClockKind whose, long now) {
    times[(int) (count % KEPT)] = now;
    count++;
    fixed = forAllTimes;
    clock = whose;
    Rival key = new Rival(authority, parent);
    Voice before = voices.get(key);
    boolean goesOn = before != null && now - before.last() <= LATELY_NANOS;
    voices.put(key, new Voice(goesOn ? before.first() : now, now));
  }

  synchronized boolean fixed() {
    return fixed;
  }

  synchronized ClockKind clock() {
    return clock;
  }

  synchronized long lastNanos() {
    return times[(int) ((count - 1) % KEPT)];
  }

  synchronized double rateHz(long now) {
    int kept = (int) Math.min(count, KEPT);
    double span = (lastNanos() - times[(int) ((count - kept) % KEPT)]) * NANO;
    if (kept < 2 || span <= 0) {
      return 0;
    }
    double mean = span / (kept - 1);
    boolean ended = (now - lastNanos()) * NANO > Math.max(PATIENCE_SECONDS, PATIENCE_PERIODS * mean);
    return ended ? 0 : 1 / mean;
  }

  /**
   * Who else says it. One who fell silent before the present one began was its predecessor, no rival; what is said for
   * all times is said once, and contradicts where it names another parent.
   */
  synchronized List<Rival> rivals(FrameId parent, String authority, long now) {
    Rival own = new Rival(authority, parent);
    long began = voices.containsKey(own) ? voices.get(own).first() : now;
    return voices.entrySet().stream().filter(e -> !e.getKey().equals(own))
        .filter(e -> fixed ? !e.getKey().parent().equals(parent)
            : e.getValue().last() - began > 0 && now - e.getValue().last() <= LATELY_NANOS)
        .map(Map.Entry::getKey).toList();
  }
}
