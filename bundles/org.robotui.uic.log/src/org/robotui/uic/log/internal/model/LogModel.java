package org.robotui.uic.log.internal.model;

import java.time.Clock;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.LongSupplier;
import org.robotui.api.port.Input;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;

/**
 * The log: takes what comes, keeps the newest, shows what the filter leaves. The tick is called on one thread; filter
 * and clearing may be asked for on any.
 */
public final class LogModel {
  /** How long a tick may look for matches. */
  public static final long BUDGET_NANOS = 60_000_000L;

  private static final long BYTES_PER_MIB = 1L << 20;

  private final Input<LogEntry> input;
  private final Intake intake;
  private final Store store = new Store();
  private final Matches matches;
  private final Rate rate = new Rate();
  private final AtomicBoolean clear = new AtomicBoolean();
  private volatile LogFilter filter = LogFilter.ALL;
  private volatile Shown shown = Shown.NOTHING;
  private volatile boolean paused;
  private Optional<Long> pausedAt = Optional.empty();
  private long total;
  private long droppedBefore;
  private boolean cleared;

  /** Over an input, with the clock that dates unstamped entries and one that measures time. */
  public LogModel(Input<LogEntry> input, Clock clock, LongSupplier nanos) {
    this.input = input;
    this.intake = new Intake(clock);
    this.matches = new Matches(nanos);
  }

  /** Takes what came; at most so many entries and so much memory are kept. Whether there is something new to show. */
  public boolean tick(long now, int capacity, long mebibytes) {
    if (clear.getAndSet(false)) {
      forget();
    }
    boolean pause = paused;
    pausedAt = pause ? Optional.of(pausedAt.orElse(store.endId())) : Optional.empty();
    // What is read during a pause must not be pushed out at once by what comes meanwhile.
    int room = pause ? 2 : 1;
    int[] count = {0};
    input.drain(envelope -> intake.take(envelope).ifPresent(entry -> {
      store.add(entry, capacity * room, mebibytes * BYTES_PER_MIB * room);
      count[0]++;
    }));
    intake.settle();
    total += count[0];
    rate.mark(now, count[0]);
    matches.follow(store, end(), filter, BUDGET_NANOS);
    Shown next = shown();
    boolean changed = count[0] > 0 || !same(shown, next);
    shown = next;
    return changed;
  }

  /** What is to be shown from the next tick on. */
  public void filter(LogFilter next) {
    filter = next;
  }

  /** What was asked for. */
  public LogFilter filter() {
    return filter;
  }

  /** Holds what is shown, from the next tick on; what comes is kept, but not shown before the pause ends. */
  public void pause(boolean on) {
    paused = on;
  }

  /** Whether what is shown is held. */
  public boolean paused() {
    return paused;
  }

  /** Forgets all entries at the next tick. */
  public void clear() {
    clear.set(true);
  }

  /** What the last tick left. */
  public Shown current() {
    return shown;
  }

  /** How many entries were compared with a filter so far, for tests of what it costs. */
  public long looked() {
    return matches.looked();
  }

  private void forget() {
    store.clear();
    pausedAt = Optional.empty();
    total = 0;
    droppedBefore = input.dropped();
    cleared = true;
  }

  private long end() {
    return pausedAt.map(at -> Math.max(at, store.firstId())).orElseGet(store::endId);
  }

  private Shown shown() {
    Map<Severity, Integer> counts = new EnumMap<>(Severity.class);
    Arrays.stream(Severity.values()).forEach(severity -> counts.put(severity, store.count(severity)));
    return new Shown(matches.lines(), filter, Map.copyOf(counts), store.origins(), store.size(), total,
        end() - matches.next(), store.endId() - end(), rate.hertz(), Math.max(0, input.dropped() - droppedBefore),
        cleared);
  }

  private static boolean same(Shown one, Shown other) {
    return one.kept() == other.kept() && one.total() == other.total() && one.lines().size() == other.lines().size()
        && one.left() == other.left() && one.held() == other.held() && one.rateHz() == other.rateHz()
        && one.dropped() == other.dropped()
        && one.filter().equals(other.filter())
        && one.filter().search().problem().equals(other.filter().search().problem())
        && one.cleared() == other.cleared();
  }
}
