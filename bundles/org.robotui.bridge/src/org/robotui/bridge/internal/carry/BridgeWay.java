package org.robotui.bridge.internal.carry;

import java.util.Optional;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.bridge.BridgeStatus;
import org.robotui.api.bridge.BridgeStatus.Counts;
import org.robotui.api.bridge.BridgeStatus.State;
import org.robotui.api.bridge.BridgeTransform.Direction;
import org.robotui.api.port.Envelope;
import org.robotui.bridge.internal.change.ValueFilter;

/** One way of a bridge. Used by the thread of the bridges; its status may be asked for by any. */
final class BridgeWay implements CarriedWay {
  private static final long ACTIVE = 1_000_000_000L;

  private final BridgeConfig config;
  private final Direction direction;
  private final WayEnds ends;
  private final CarryContext surroundings;
  private final WaitingValues waiting;
  private final Optional<ValueFilter> filter;
  private final WayTally tally = new WayTally();
  private Optional<OpenWay> open = Optional.empty();
  private Optional<Envelope<?>> kept = Optional.empty();
  private boolean present;
  private long received;
  private long lost;
  private long filtered;
  private long nextSequence = -1;
  private long active = System.nanoTime() - ACTIVE;
  private volatile BridgeStatus status;

  BridgeWay(BridgeConfig config, Direction direction, CarryContext surroundings) {
    this.config = config;
    this.direction = direction;
    this.ends = WayEnds.of(config, direction);
    this.surroundings = surroundings;
    this.waiting = new WaitingValues(config.settings());
    this.filter = ValueFilter.of(config.settings(), ends.from().port());
    this.status = status(State.WAITING, "not begun yet");
  }

  @Override
  public BridgeStatus status() {
    return status;
  }

  @Override
  public boolean isWaiting() {
    return !waiting.isEmpty();
  }

  /** Opens it anew where a robot UI has come, gone or been replaced, and says how it is doing. */
  @Override
  public void look(long now) {
    if (open.filter(way -> !way.isCurrent(surroundings)).isPresent()) {
      close();
    }
    if (open.isEmpty()) {
      open = OpenWay.of(config, direction, ends, surroundings);
    }
    open.ifPresent(way -> {
      boolean there = way.far().isThere();
      if (there && !present) {
        kept.ifPresent(waiting::add);
      }
      present = there;
      way.far().tick(now);
    });
    status = measured();
  }

  @Override
  public void carry(long now) {
    open.ifPresent(way -> {
      way.near().take(ends.from().port(), this::received);
      Optional<Envelope<?>> next = waiting.next(now);
      while (next.isPresent() && pass(way, next.get(), now)) {
        waiting.passed(now);
        next = waiting.next(now);
      }
    });
  }

  private void received(Envelope<?> envelope) {
    if (nextSequence >= 0 && envelope.sequence() > nextSequence) {
      lost += envelope.sequence() - nextSequence;
    }
    nextSequence = envelope.sequence() + 1;
    received++;
    active = System.nanoTime();
    if (isWanted(envelope)) {
      waiting.add(envelope);
    }
  }

  private boolean isWanted(Envelope<?> envelope) {
    try {
      boolean passes = filter.isEmpty() || filter.get().passes(envelope);
      filtered += passes ? 0 : 1;
      return passes;
    } catch (IllegalArgumentException e) {
      tally.answered(Optional.of(String.valueOf(e.getMessage())), envelope.receivedNanos());
      return false;
    }
  }

  /** False where it is to be tried again. What holds until it is replaced is said again to a robot that comes later. */
  private boolean pass(OpenWay way, Envelope<?> envelope, long now) {
    if (way.isKept(envelope)) {
      kept = Optional.of(envelope);
    }
    return way.pass(envelope, reason -> tally.answered(reason, envelope.receivedNanos()), now);
  }

  private BridgeStatus measured() {
    if (open.isEmpty()) {
      return status(State.WAITING, OpenWay.missing(ends, surroundings));
    }
    OpenWay way = open.get();
    Optional<String> wrong = way.wrong();
    if (wrong.isPresent()) {
      return status(State.WRONG, wrong.get());
    }
    Optional<String> refusal = tally.refusal().or(() -> way.far().problem());
    boolean live = System.nanoTime() - active < 3 * ACTIVE;
    if (refusal.isPresent() && live) {
      return status(State.REFUSED, refusal.get());
    }
    if (!way.far().isThere()) {
      return status(State.WAITING, way.far().missing());
    }
    return live && tally.passed() > 0 ? status(State.CARRYING, "carrying")
        : status(State.WAITING, live && filtered > 0 ? "no value has met 'when' yet"
            : way.near().state(ends.from().port()).explanation());
  }

  private BridgeStatus status(State state, String text) {
    Counts counts =
        new Counts(received, tally.passed(), filtered + waiting.thinned(), lost + waiting.dropped(), tally.refused());
    return new BridgeStatus(config.name(), ends.from(), ends.to(), state, text, counts, tally.rateHz(),
        tally.lagSeconds(),
        open.flatMap(way -> way.far().holder()));
  }

  @Override
  public void close() {
    open.ifPresent(OpenWay::close);
    open = Optional.empty();
    present = false;
    nextSequence = -1;
  }
}
