package org.robotui.bridge.internal.carry;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.Lock;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.bridge.BridgeStatus;
import org.robotui.api.bridge.BridgeStatus.Counts;
import org.robotui.api.bridge.BridgeStatus.State;
import org.robotui.api.bridge.BridgeTransform.Direction;
import org.robotui.api.port.CallException;

/**
 * One way of a parameter that two robots share: what it becomes at one of them is set at the other. It is looked at
 * again and again, on a thread of its own. The two ways of one bridge share a lock, so that they never set what the
 * other one is just looking at.
 */
final class ParameterWay implements CarriedWay {
  private static final long AGAIN = Duration.ofSeconds(1).toNanos();

  private final BridgeConfig config;
  private final Direction direction;
  private final WayEnds ends;
  private final CarryContext surroundings;
  private final Lock lock;
  /** Whether nobody but this way sets it at the other robot. */
  private final boolean alone;
  private final WayTally tally = new WayTally();
  private final AtomicLong received = new AtomicLong();
  private final AtomicBoolean looking = new AtomicBoolean();
  private Optional<ParameterRoute> open = Optional.empty();
  private long due = System.nanoTime();
  private volatile Optional<Object> carried = Optional.empty();
  private volatile Optional<String> problem = Optional.of("not looked at yet");
  private volatile BridgeStatus status;

  ParameterWay(BridgeConfig config, Direction direction, CarryContext surroundings, Lock lock) {
    this.config = config;
    this.direction = direction;
    this.ends = WayEnds.of(config, direction);
    this.surroundings = surroundings;
    this.lock = lock;
    this.alone = !config.settings().flag("both");
    this.status = status(State.WAITING, "not begun yet");
  }

  @Override
  public BridgeStatus status() {
    return status;
  }

  @Override
  public void look(long now) {
    if (open.filter(route -> !route.isCurrent(surroundings)).isPresent()) {
      close();
    }
    if (open.isEmpty()) {
      open = ParameterRoute.of(ends, surroundings);
    }
    open.ifPresent(route -> {
      route.far().tick(now);
      if (now - due >= 0 && route.missing().isEmpty() && looking.compareAndSet(false, true)) {
        due = now + AGAIN;
        Thread.ofVirtual().name("bridge-" + config.name()).start(() -> compare(route));
      }
    });
    status = measured();
  }

  private void compare(ParameterRoute route) {
    lock.lock();
    try {
      Optional<Object> value = route.near().value();
      problem = value.isPresent() ? Optional.empty() : Optional.of(ends.from() + " is not set");
      if (value.isPresent() && (alone || !value.equals(carried))) {
        compared(route, value.get());
      }
    } catch (CallException e) {
      problem = Optional.of(e.getMessage());
    } finally {
      lock.unlock();
      looking.set(false);
    }
  }

  /** The way back says nothing of the value that it begins with: at first the robot of 'from' is right. */
  private void compared(ParameterRoute route, Object value) throws CallException {
    boolean first = carried.isEmpty() && direction == Direction.BACK;
    if (!first && !route.far().value().equals(Optional.of(value))) {
      received.incrementAndGet();
      set(route, value, System.nanoTime());
    } else {
      carried = Optional.of(value);
    }
  }

  /** What is refused is tried again with the next look. */
  private void set(ParameterRoute route, Object value, long began) {
    try {
      route.far().set(value);
      carried = Optional.of(value);
      tally.answered(Optional.empty(), began);
    } catch (CallException e) {
      tally.answered(Optional.of(e.getMessage()), began);
    }
  }

  private BridgeStatus measured() {
    if (open.isEmpty()) {
      return status(State.WAITING, OpenWay.missing(ends, surroundings));
    }
    Optional<String> missing = open.get().missing().or(() -> problem);
    if (missing.isPresent()) {
      return status(State.WAITING, missing.get());
    }
    return tally.refusal().map(reason -> status(State.REFUSED, reason))
        .orElseGet(() -> status(State.CARRYING, "both have " + carried.orElse("none")));
  }

  private BridgeStatus status(State state, String text) {
    Counts counts = new Counts(received.get(), tally.passed(), 0, 0, tally.refused());
    return new BridgeStatus(config.name(), ends.from(), ends.to(), state, text, counts, tally.rateHz(),
        tally.lagSeconds(),
        open.flatMap(route -> route.far().holder()));
  }

  @Override
  public void close() {
    open.ifPresent(ParameterRoute::close);
    open = Optional.empty();
    carried = Optional.empty();
    problem = Optional.of("not looked at yet");
    due = System.nanoTime();
  }
}
