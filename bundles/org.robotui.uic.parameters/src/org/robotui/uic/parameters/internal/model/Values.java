package org.robotui.uic.parameters.internal.model;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;

/** The values of parameters: read in the background, a few at a time, and only those that are seen. */
final class Values {
  static final int BATCH = 32;

  private static final long LONG_AGO_NANOS = 1_000_000_000_000_000L;

  private final Map<Key, Held> held = new ConcurrentHashMap<>();
  private final Function<String, Optional<Browser>> browsers;
  private final Executor background;
  private final AtomicBoolean reading = new AtomicBoolean();
  private final AtomicLong version = new AtomicLong();
  private volatile long restUntil;
  private volatile boolean resting;

  Values(Function<String, Optional<Browser>> browsers, Executor background) {
    this.browsers = browsers;
    this.background = background;
  }

  Optional<Held> get(Key key) {
    return Optional.ofNullable(held.get(key));
  }

  /** Changes whenever a value does. */
  long version() {
    return version.get();
  }

  /** Reads what is seen and not known, then what was read longest ago. */
  void tick(long now, List<Key> seen, long periodNanos) {
    if (resting && now - restUntil < 0 || reading.get()) {
      return;
    }
    List<Key> due = new ArrayList<>(seen.stream().filter(key -> isDue(key, now, periodNanos)).toList());
    due.sort(Comparator.comparing((Key key) -> held.containsKey(key))
        .thenComparing(key -> get(key).map(Held::readAt).orElse(0L)));
    if (!due.isEmpty() && reading.compareAndSet(false, true)) {
      List<Key> batch = List.copyOf(due.subList(0, Math.min(BATCH, due.size())));
      background.execute(() -> readAll(batch, now, periodNanos));
    }
  }

  /** What is known is old from now on. */
  void expire() {
    resting = false;
    long old = System.nanoTime() - LONG_AGO_NANOS;
    held.replaceAll((key, value) -> value.expired(old));
    version.incrementAndGet();
  }

  /** Reads one value now; blocks. */
  Optional<Object> read(Key key) throws CallException {
    Optional<Object> value = browser(key).parameter(key.name());
    change(key, Held.read(get(key), value, System.nanoTime()));
    return value;
  }

  /** Sets a value; blocks. */
  void write(Key key, Object value) throws CallException {
    browser(key).setParameter(key.name(), value);
    held(key, before -> before.set(value, System.nanoTime()));
  }

  void busy(Key key) {
    held(key, Held::setting);
  }

  void wrong(Key key, String why) {
    held(key, before -> before.wrong(why, System.nanoTime()));
  }

  private boolean isDue(Key key, long now, long periodNanos) {
    Held known = held.get(key);
    return known == null || !known.busy() && now - known.readAt() >= periodNanos;
  }

  private void readAll(List<Key> batch, long now, long periodNanos) {
    try {
      for (Key key : batch) {
        read(key);
      }
    } catch (CallException e) {
      // One that does not answer is not asked for each value in turn.
      batch.stream().filter(key -> !held.containsKey(key) || get(key).flatMap(Held::problem).isPresent())
          .forEach(key -> wrong(key, e.getMessage()));
      restUntil = now + periodNanos;
      resting = true;
    } finally {
      reading.set(false);
    }
  }

  private Browser browser(Key key) throws CallException {
    return browsers.apply(key.robot()).orElseThrow(() -> new CallException(key.robot() + " cannot be asked now"));
  }

  private void held(Key key, Function<Held, Held> next) {
    Held before = get(key).orElse(Held.NOTHING);
    change(key, next.apply(before));
  }

  private void change(Key key, Held next) {
    Held before = held.put(key, next);
    boolean same = before != null && before.value().equals(next.value()) && before.problem().equals(next.problem())
        && before.busy() == next.busy() && before.first().equals(next.first());
    if (!same) {
      version.incrementAndGet();
    }
  }
}
