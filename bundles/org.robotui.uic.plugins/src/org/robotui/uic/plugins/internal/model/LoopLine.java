package org.robotui.uic.plugins.internal.model;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.data.control.Histogram;
import org.robotui.data.control.LoopTiming.Counts;
import org.robotui.data.control.LoopTiming.Loop;
import org.robotui.data.control.LoopTiming.Schedule;
import org.robotui.ui.Health;

/**
 * A thread, with its plugins below it.
 *
 * @param process the process it lives in
 * @param thread its name; may be empty where the process is not there
 * @param schedule when it runs, where it is measured
 * @param counts what it did, where it is measured
 * @param wakeUp how late it woke
 * @param busy how long one cycle took
 * @param period nanoseconds
 */
public record LoopLine(String process, String thread, Optional<Schedule> schedule, Counts counts, Evidence wakeUp,
    Evidence busy, long period)
    implements Line {
  private static final int BY_DEADLINE = 100;
  private static final Histogram NOTHING = new Histogram(List.of(), List.of(), 0);

  /** A thread that is measured. */
  static LoopLine of(Loop loop, Optional<Loop> earlier) {
    Optional<Loop> before = earlier.filter(e -> e.counts().cycles() <= loop.counts().cycles());
    return new LoopLine(loop.process(), loop.name(), Optional.of(loop.schedule()),
        before.map(e -> less(loop.counts(), e.counts())).orElse(loop.counts()),
        Evidence.of(loop.wakeUp(), before.map(Loop::wakeUp)), Evidence.of(loop.busy(), before.map(Loop::busy)),
        loop.schedule().period());
  }

  /** A thread of which nothing is known but that plugins belong there. */
  static LoopLine unmeasured(String process, String thread, long period) {
    Evidence none = Evidence.of(NOTHING, Optional.empty());
    return new LoopLine(process, thread, Optional.empty(), new Counts(0, 0, 0, 0, 0), none, none, period);
  }

  private static Counts less(Counts now, Counts then) {
    return new Counts(now.cycles() - then.cycles(), now.overruns() - then.overruns(), now.missed() - then.missed(),
        now.allocations() - then.allocations(), now.pageFaults() - then.pageFaults());
  }

  @Override
  public String key() {
    return "loop " + process + "/" + thread;
  }

  @Override
  public String name() {
    return thread.isEmpty() || thread.equals(process) ? process : process + " \u00b7 " + thread;
  }

  @Override
  public Health health() {
    if (schedule.isEmpty()) {
      return Health.NONE;
    }
    return counts.overruns() + counts.missed() + counts.allocations() > 0 || busy.share(period) >= 1 ? Health.WARNING
        : Health.OK;
  }

  @Override
  public String word() {
    return schedule.map(s -> Durations.period(s.period())).orElse("unmeasured");
  }

  /** When it runs, for a reader. */
  public String scheduled() {
    return schedule.map(s -> Stream.of("every " + Durations.period(s.period()),
        s.priority() == BY_DEADLINE ? "by deadline"
            : s.priority() > 0 ? "real-time priority " + s.priority() : "no real-time priority",
        s.core() >= 0 ? "processor " + s.core() : "any processor").collect(Collectors.joining(", ")))
        .orElse("This thread is not measured");
  }

  @Override
  public String words() {
    if (schedule.isEmpty()) {
      return "";
    }
    return Stream.of(
        "wakes p99 " + Durations.of(wakeUp.p99()) + ", max " + wakeUp.longest(),
        some(counts.overruns(), "overrun", "overruns"), some(counts.missed(), "missed", "missed"),
        some(counts.allocations(), "allocation", "allocations"), some(counts.pageFaults(), "page fault", "page faults"))
        .filter(part -> !part.isEmpty()).collect(Collectors.joining(" \u00b7 "));
  }

  private static String some(long count, String one, String many) {
    return count == 0 ? "" : Durations.count(count) + " " + (count == 1 ? one : many);
  }
}
