package org.robotui.uic.log.internal.model;

import java.time.Clock;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.Envelope;
import org.robotui.data.status.LogEntry;

/** Makes entries of what comes: each once, and none longer than can be kept. One thread. */
final class Intake {
  /** Characters of a message that are kept. */
  static final int LONGEST_MESSAGE = 1 << 18;

  private static final int LONGEST_NAME = 256;
  private static final int LONGEST_LOCATION = 1024;
  private static final int SHARED_NAMES = 2000;
  private static final long NANOS_PER_SECOND = 1_000_000_000L;

  private final Twins twins = new Twins();
  private final Map<String, String> names = new LinkedHashMap<>();
  private final Clock clock;
  private long nextId;

  /** With the clock that dates what carries no stamp. */
  Intake(Clock clock) {
    this.clock = clock;
  }

  /** The entry, or none where another source gave it already. */
  Optional<Entry> take(Envelope<LogEntry> envelope) {
    LogEntry value = envelope.value();
    String origin = shared(cut(value.origin(), LONGEST_NAME));
    if (twins.isTwin(envelope, origin)) {
      return Optional.empty();
    }
    String message = cut(value.message(), LONGEST_MESSAGE);
    return Optional
        .of(new Entry(nextId++, value.severity(), origin, message, shared(cut(value.location(), LONGEST_LOCATION)),
            nanos(envelope), value.message().length() - message.length()));
  }

  /** To be called after each drain. */
  void settle() {
    twins.settle();
  }

  private long nanos(Envelope<LogEntry> envelope) {
    return envelope.stamp().map(stamp -> stamp.nanos()).orElseGet(() -> {
      Instant now = clock.instant();
      return now.getEpochSecond() * NANOS_PER_SECOND + now.getNano();
    });
  }

  /** Names come with every entry anew; one copy of each will do. */
  private String shared(String name) {
    if (names.size() >= SHARED_NAMES) {
      names.clear();
    }
    return names.computeIfAbsent(name, n -> n);
  }

  private static String cut(String text, int most) {
    if (text.length() <= most) {
      return text;
    }
    return text.substring(0, Character.isHighSurrogate(text.charAt(most - 1)) ? most - 1 : most);
  }
}
