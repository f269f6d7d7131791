package org.robotui.rfic.recording.internal.align;

import java.io.IOException;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.robotui.api.port.Input;
import org.robotui.api.port.RawMessage;
import org.robotui.api.replay.HistoryTaker;
import org.robotui.api.replay.OffsetEstimate;
import org.robotui.api.replay.RecordedValue;
import org.robotui.data.array.Bytes;
import org.robotui.rfic.recording.internal.time.SearchableHistory;

/**
 * The messages that two recorders of one robot both wrote: the same bytes at two times. A message that one of them has
 * twice tells nothing.
 */
final class SharedMessages {
  /** Shorter ones, such as flags, are the same by chance. */
  private static final int SHORTEST = 16;
  private static final int LEAST = 5;
  private static final int MOST = 200_000;
  /** Pictures and clouds are read slowly, and smaller messages tell as much. */
  private static final Set<String> LARGE = Set.of("RawImage", "CompressedImage", "Image", "PointCloud", "GridMap");
  /** Of a normal distribution, the deviation by the median of distances. */
  private static final double DEVIATION = 1.4826;
  /** Messages that are that far apart are no longer the same ones. */
  private static final double MOST_DEVIATION = 1e9;

  private record Said(String port, int size, long hash) {}

  private SharedMessages() {}

  /** What is added to the times of the second one; empty where they share too little. */
  static Optional<OffsetEstimate> offset(SearchableHistory reference, SearchableHistory moved)
      throws IOException, InterruptedException {
    Set<String> ports = ports(reference);
    ports.retainAll(ports(moved));
    if (ports.isEmpty()) {
      return Optional.empty();
    }
    Map<Said, Long> one = times(reference, ports);
    Map<Said, Long> other = times(moved, ports);
    long[] apart = other.entrySet().stream().filter(each -> one.getOrDefault(each.getKey(), -1L) >= 0
        && each.getValue() >= 0).mapToLong(each -> one.get(each.getKey()) - each.getValue()).sorted().toArray();
    return apart.length < LEAST ? Optional.empty()
        : Optional.of(estimate(apart)).filter(found -> found.deviation() < MOST_DEVIATION);
  }

  private static OffsetEstimate estimate(long[] sorted) {
    long median = sorted[sorted.length / 2];
    long[] distances = Arrays.stream(sorted).map(each -> Math.abs(each - median)).sorted().toArray();
    double deviation = DEVIATION * distances[distances.length / 2];
    return new OffsetEstimate(median, Math.round(deviation), sorted.length + " messages that both have");
  }

  private static Set<String> ports(SearchableHistory history) {
    return history.candidates().stream().filter(each -> !LARGE.contains(each.typeName()))
        .map(Input.Candidate::id).map(id -> id.port()).collect(Collectors.toSet());
  }

  /** When each message was recorded; -1 for those that came twice. */
  private static Map<Said, Long> times(SearchableHistory history, Set<String> ports)
      throws IOException, InterruptedException {
    Map<Said, Long> times = new HashMap<>();
    history.read(ports, history.span(), new HistoryTaker() {
      @Override
      public void take(RecordedValue value) {
        value.raw().map(RawMessage::bytes).filter(bytes -> bytes.size() >= SHORTEST)
            .ifPresent(bytes -> times.merge(said(value.port(), bytes), value.time(), (before, now) -> -1L));
      }

      @Override
      public boolean reached(long time) {
        return times.size() < MOST;
      }
    });
    return times;
  }

  private static Said said(String port, Bytes bytes) {
    long hash = 0xcbf29ce484222325L;
    for (int i = 0; i < bytes.size(); i++) {
      hash = (hash ^ bytes.unsigned(i)) * 0x100000001b3L;
    }
    return new Said(port, bytes.size(), hash);
  }
}
