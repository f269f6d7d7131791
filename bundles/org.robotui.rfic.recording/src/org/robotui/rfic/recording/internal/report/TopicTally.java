package org.robotui.rfic.recording.internal.report;

import java.util.Optional;
import org.robotui.api.replay.TimeRange;

/** How the messages of a topic lie in time. For one thread. */
final class TopicTally {
  /** A gap is worth a word where it is so many times as long as messages are apart otherwise. */
  private static final double NOTABLE = 5;
  private static final int FEW = 10;
  private static final long SHORTEST_GAP = 500_000_000L;

  private final String port;
  private final String type;
  private final TimeBins bins;
  private final int[] densities;
  private long count;
  private Optional<String> unreadable = Optional.empty();
  private long first;
  private long last;
  private TimeRange longest = new TimeRange(0, 0);

  TopicTally(String port, String type, TimeBins bins) {
    this.port = port;
    this.type = type;
    this.bins = bins;
    this.densities = new int[bins.count()];
  }

  void take(long time) {
    if (count == 0) {
      first = time;
    } else if (time - last > longest.length()) {
      longest = new TimeRange(last, time);
    }
    last = time;
    count++;
    densities[bins.of(time)]++;
  }

  void unreadable(String reason) {
    unreadable = unreadable.or(() -> Optional.of(reason));
  }

  String port() {
    return port;
  }

  String type() {
    return type;
  }

  long count() {
    return count;
  }

  /** Why messages of it could not be read; none where all could. */
  Optional<String> obstacle() {
    return unreadable;
  }

  int density(int bin) {
    return densities[bin];
  }

  /** Messages per second between the first and the last one; 0 where that tells nothing of so few. */
  double rate() {
    return count < FEW || last == first ? 0 : (count - 1) * 1e9 / (last - first);
  }

  /** The longest time without a message, between two of them. */
  TimeRange longestGap() {
    return longest;
  }

  /** Whether that is much longer than usual. */
  boolean hasGap() {
    return rate() > 0 && longest.length() > Math.max(SHORTEST_GAP, NOTABLE * 1e9 / rate());
  }
}
