package org.robotui.rfic.recording.internal.find;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongPredicate;
import java.util.stream.Collectors;
import org.robotui.api.port.Input;
import org.robotui.api.replay.HistoryTaker;
import org.robotui.api.replay.RecordedValue;
import org.robotui.api.replay.TimeRange;
import org.robotui.condition.TimedCondition;
import org.robotui.condition.Verdict;
import org.robotui.rfic.recording.internal.time.SearchableHistory;

/**
 * Asks a condition of all of a recording: after each value, and as often between values as an alert would look. For one
 * thread.
 */
public final class ConditionScan {
  private static final long LOOK_NANOS = 100_000_000L;
  private static final long PRECISION_NANOS = 1_000_000L;
  /** A recording may stand for days between two values. */
  private static final long MOST_LOOKS = 10_000;

  private final List<Input.Candidate> sources;
  private final RecordedSignals signals;
  private final SpanWatch watch;
  private long now;
  private boolean begun;
  private long values;
  private long unreadable;
  private Optional<String> problem = Optional.empty();

  private ConditionScan(TimedCondition timed, List<Input.Candidate> sources, long start, Consumer<FoundSpan> found) {
    this.sources = sources;
    this.signals = new RecordedSignals(sources, start);
    this.watch = new SpanWatch(timed, signals, found);
  }

  /**
   * The streams of a recording that a condition looks at.
   *
   * @param timed the condition
   * @param history the recording
   * @return none where it has nothing of what the condition names
   */
  public static List<Input.Candidate> sources(TimedCondition timed, SearchableHistory history) {
    return history.candidates().stream().filter(timed.condition().needs()).toList();
  }

  /**
   * Scans a recording.
   *
   * @param timed the condition, of which nothing was asked yet
   * @param history the recording
   * @param range what of it, in its times
   * @param found is given what is found, on this thread
   * @param goesOn is told how far it is; false where no more is wanted
   * @return what became of it
   * @throws IOException where the file cannot be read any more
   * @throws InterruptedException where the thread was interrupted
   */
  public static ScanOutcome run(TimedCondition timed, SearchableHistory history, TimeRange range,
      Consumer<FoundSpan> found, LongPredicate goesOn) throws IOException, InterruptedException {
    ConditionScan scan = new ConditionScan(timed, sources(timed, history), range.start(), found);
    return scan.run(history, range, goesOn);
  }

  private ScanOutcome run(SearchableHistory history, TimeRange range, LongPredicate goesOn)
      throws IOException, InterruptedException {
    boolean[] ended = {false};
    history.read(sources.stream().map(each -> each.id().port()).collect(Collectors.toSet()), range,
        new HistoryTaker() {
          @Override
          public void take(RecordedValue value) {
            ConditionScan.this.take(value);
          }

          @Override
          public void unreadable(String port, String reason) {
            unreadable++;
            problem = problem.or(() -> Optional.of(port + ": " + reason));
          }

          @Override
          public boolean reached(long time) {
            ended[0] = !goesOn.test(time);
            return !ended[0];
          }
        });
    if (!ended[0]) {
      pass(range.end());
      watch.end(range.end(), false);
    }
    return new ScanOutcome(values, unreadable, problem, watch.neverKnown());
  }

  private void take(RecordedValue value) {
    values++;
    if (value.time() > now) {
      pass(value.time());
    }
    signals.take(value);
    look(value.time());
    begun = true;
  }

  /** Looks at what time alone brings about, until just before a time. */
  private void pass(long until) {
    if (begun && watch.lasts()) {
      long step = Math.max(LOOK_NANOS, (until - now) / MOST_LOOKS);
      for (long at = now + step; at < until && at > now; at += step) {
        lookAhead(at);
      }
      if (until - 1 > now) {
        lookAhead(until - 1);
      }
    }
  }

  /** Where the answer is another one, since when is sought. */
  private void lookAhead(long time) {
    Class<? extends Verdict> before = verdict(now);
    if (verdict(time) != before) {
      long from = now;
      long to = time;
      while (to - from > PRECISION_NANOS) {
        long middle = from + (to - from) / 2;
        if (verdict(middle) == before) {
          from = middle;
        } else {
          to = middle;
        }
      }
      look(to);
    }
    look(time);
  }

  private Class<? extends Verdict> verdict(long time) {
    signals.at(time);
    return watch.verdict().getClass();
  }

  private void look(long time) {
    now = time;
    signals.at(time);
    watch.look(time);
    signals.looked();
  }
}
