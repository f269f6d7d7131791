package org.robotui.rfic.recording.internal.session;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.robotui.recording.RecordedMessage;
import org.robotui.recording.RecordingCursor;
import org.robotui.recording.RecordingException;
import org.robotui.recording.RecordingInterval;
import org.robotui.recording.RecordingReader;
import org.robotui.rfic.recording.internal.session.Reception.Past;

/**
 * Finds what of the past holds at a time: what somebody would have been told who had listened until then, as far as it
 * matters to views.
 *
 * @param recording the recording
 */
record PastMessages(RecordingReader recording) {
  /** So much is always read of topics whose messages add to each other. */
  private static final long LATELY_NANOS = TimeUnit.SECONDS.toNanos(3);
  private static final long LONGEST_NANOS = TimeUnit.SECONDS.toNanos(60);
  /** And more for so long by the clock of this machine. */
  private static final long PATIENCE_NANOS = TimeUnit.MILLISECONDS.toNanos(200);
  private static final int MOST = 20_000;
  /** What is said for good is said a few times; who says it again and again says it again soon. */
  private static final long FEW = 100;
  private static final Comparator<RecordedMessage> ORDER = Comparator.comparingLong(RecordedMessage::logTime);

  /** What holds of some topics; by time. */
  List<RecordedMessage> at(long time, List<Reception<?>> wanted) throws RecordingException {
    Map<Integer, Past> channels = new TreeMap<>();
    wanted.forEach(each -> each.channels()
        .forEach(channel -> channels.merge(channel.channel().id(), past(each, channel), PastMessages::more)));
    List<RecordedMessage> found = new ArrayList<>();
    for (Map.Entry<Integer, Past> each : channels.entrySet()) {
      switch (each.getValue()) {
        case ALL -> found.addAll(between(Long.MIN_VALUE, time, Set.of(each.getKey())));
        case LAST -> recording.latestBefore(each.getKey(), time).ifPresent(found::add);
        case LATELY, NOTHING -> {}
      }
    }
    found.addAll(lately(time, channels.keySet().stream().filter(id -> channels.get(id) == Past.LATELY)
        .collect(Collectors.toSet())));
    return found.stream().sorted(ORDER).toList();
  }

  private static Past past(Reception<?> reception, PlayedChannel channel) {
    return reception.past() == Past.ALL && channel.count() > FEW ? Past.LATELY : reception.past();
  }

  private static Past more(Past one, Past other) {
    return one.compareTo(other) > 0 ? one : other;
  }

  /** Goes back in steps that become longer, and for a message at least of each channel. */
  private List<RecordedMessage> lately(long time, Set<Integer> channels) throws RecordingException {
    if (channels.isEmpty()) {
      return List.of();
    }
    long start = recording.span().map(RecordingInterval::start).orElse(time);
    long until = System.nanoTime() + PATIENCE_NANOS;
    List<RecordedMessage> found = new ArrayList<>(between(time - LATELY_NANOS, time, channels));
    long from = time - LATELY_NANOS;
    for (long step = LATELY_NANOS; from > start && time - from < LONGEST_NANOS && found.size() < MOST
        && System.nanoTime() - until < 0; step *= 2) {
      found.addAll(between(from - step, from - 1, channels));
      from -= step;
    }
    Set<Integer> present = found.stream().map(each -> each.channel().id()).collect(Collectors.toSet());
    for (int channel : channels) {
      if (!present.contains(channel)) {
        recording.latestBefore(channel, time).ifPresent(found::add);
      }
    }
    return found;
  }

  private List<RecordedMessage> between(long from, long to, Set<Integer> channels) throws RecordingException {
    List<RecordedMessage> found = new ArrayList<>();
    if (from <= to) {
      RecordingCursor cursor = recording.cursor(new RecordingInterval(from, to), channels);
      for (Optional<RecordedMessage> next = cursor.next(); next.isPresent() && found.size() < MOST; next =
          cursor.next()) {
        found.add(Reception.copied(next.get()));
      }
    }
    return found;
  }
}
