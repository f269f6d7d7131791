package org.robotui.uic.log.internal.model;

import java.time.Clock;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.api.port.SourceId;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.testkit.FakeInput;

/** A log in a test's hands, at 2026-01-02 03:04:05 UTC; looking at an entry takes 1 microsecond of its time. */
final class Log {
  static final SourceId DIRECT = new SourceId("base", "/rosout");
  static final SourceId REPEATED = new SourceId("base", "/rosout_agg");
  static final long SECOND = 1_000_000_000L;
  static final long START = Instant.parse("2026-01-02T03:04:05Z").getEpochSecond() * SECOND;

  final FakeInput<LogEntry> input = new FakeInput<>();
  final AtomicLong time = new AtomicLong();
  private final Clock clock = Clock.fixed(Instant.ofEpochSecond(START / SECOND), ZoneOffset.UTC);
  final LogModel model = new LogModel(input, clock, this::nanos);
  long nanosPerLook = 1000;
  int capacity = 50_000;
  long mebibytes = 64;

  Log say(Severity severity, String origin, String message) {
    return say(DIRECT, 0, new LogEntry(severity, origin, message, ""));
  }

  Log say(SourceId source, double at, LogEntry entry) {
    long nanos = (long) (at * SECOND);
    input.put(source, entry, nanos, Optional.of(new Stamp(START, ClockKind.ROBOT)));
    return this;
  }

  Log info(String... messages) {
    for (String message : messages) {
      say(Severity.INFO, "/node", message);
    }
    return this;
  }

  private long nanos() {
    return time.addAndGet(nanosPerLook);
  }

  boolean tick() {
    return model.tick(time.get(), capacity, mebibytes);
  }

  List<String> messages() {
    tick();
    return shown();
  }

  List<String> shown() {
    return model.current().lines().stream().map(line -> line.last().message()).toList();
  }
}
