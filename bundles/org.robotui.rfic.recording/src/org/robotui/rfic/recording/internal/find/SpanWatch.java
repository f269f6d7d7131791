package org.robotui.rfic.recording.internal.find;

import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Consumer;
import org.robotui.api.replay.TimeRange;
import org.robotui.condition.Condition;
import org.robotui.condition.Signals;
import org.robotui.condition.TimedCondition;
import org.robotui.condition.Verdict;

/** Watches a condition as an alert does, and tells when it held. For one thread. */
final class SpanWatch {
  private final Condition condition;
  private final long forNanos;
  private final Signals signals;
  private final Consumer<FoundSpan> found;
  private OptionalLong since = OptionalLong.empty();
  private String words = "";
  private boolean active;
  private boolean known;
  private Optional<String> unknown = Optional.empty();

  SpanWatch(TimedCondition timed, Signals signals, Consumer<FoundSpan> found) {
    this.condition = timed.condition();
    this.forNanos = timed.forNanos();
    this.signals = signals;
    this.found = found;
  }

  /** Whether it lasts, so that it may begin and end while nothing is said. */
  boolean lasts() {
    return !condition.momentary();
  }

  Verdict verdict() {
    return condition.check(signals, active);
  }

  /** Takes up what the signals say at a time. */
  void look(long time) {
    switch (verdict()) {
      case Verdict.Holds holds -> holds(holds, time);
      case Verdict.Fails fails -> {
        known = true;
        end(time, true);
      }
      case Verdict.Unknown open -> {
        unknown = unknown.or(() -> Optional.of(open.reason()));
        // What was on stays on, as of alerts; what has not lasted long enough begins anew.
        since = active ? since : OptionalLong.empty();
      }
    }
  }

  private void holds(Verdict.Holds holds, long time) {
    known = true;
    if (!lasts()) {
      found.accept(new FoundSpan(new TimeRange(time, time), true, holds.detail()));
      return;
    }
    if (since.isEmpty()) {
      since = OptionalLong.of(time);
      words = holds.detail();
    }
    active |= time - since.getAsLong() >= forNanos;
  }

  /** It does not hold any more; {@code over} is false where only the recording ends. */
  void end(long time, boolean over) {
    if (active) {
      found.accept(new FoundSpan(new TimeRange(since.orElse(time), time), over, words));
    }
    active = false;
    since = OptionalLong.empty();
  }

  /** Why it could never be told whether it holds; none where that was known at any time. */
  Optional<String> neverKnown() {
    return known ? Optional.empty() : unknown;
  }
}
