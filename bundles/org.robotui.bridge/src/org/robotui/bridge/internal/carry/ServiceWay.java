package org.robotui.bridge.internal.carry;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Supplier;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.bridge.BridgeStatus;
import org.robotui.api.bridge.BridgeStatus.Counts;
import org.robotui.api.bridge.BridgeStatus.State;
import org.robotui.api.port.ActionReply;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.Caller.Call;
import org.robotui.api.port.ServiceGrant;
import org.robotui.bridge.internal.far.MappedCall;

/**
 * A service or an action of one robot, offered to the programs of another one as long as both are there. Calls never
 * come to the thread of the bridges.
 */
final class ServiceWay implements CarriedWay {
  private static final long AGAIN = 2_000_000_000L;
  private static final long RECENT = 3_000_000_000L;

  private final BridgeConfig config;
  private final WayEnds ends;
  private final CarryContext surroundings;
  private final WayTally tally = new WayTally();
  private final AtomicLong received = new AtomicLong();
  private final AtomicBoolean offering = new AtomicBoolean();
  private Optional<ServiceRoute> open = Optional.empty();
  private long due = System.nanoTime();
  private volatile long called = System.nanoTime() - RECENT;
  private volatile Offered offered = Offered.NOT_YET;
  private volatile BridgeStatus status;

  /** What has become of the last offer. */
  private record Offered(boolean stands, String text) {
    static final Offered NOT_YET = new Offered(false, "not offered yet");
  }

  ServiceWay(BridgeConfig config, CarryContext surroundings) {
    this.config = config;
    this.ends = WayEnds.of(config);
    this.surroundings = surroundings;
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
      open = ServiceRoute.of(config, ends, surroundings);
    }
    open.ifPresent(route -> {
      route.robot().tick(now);
      if (now - due >= 0 && route.missing().isEmpty() && offering.compareAndSet(false, true)) {
        due = now + AGAIN;
        Thread.ofVirtual().name("bridge-" + config.name()).start(() -> offer(route));
      }
    });
    status = measured();
  }

  private void offer(ServiceRoute route) {
    try {
      ServiceGrant grant = route.offer(this::answered);
      offered = new Offered(true, "offered as " + grant.name() + " (" + grant.type() + ")");
    } catch (CallException e) {
      offered = new Offered(false, e.getMessage());
    } finally {
      offering.set(false);
    }
  }

  private Call<ActionReply> answered(Supplier<Call<ActionReply>> asked) {
    received.incrementAndGet();
    long began = System.nanoTime();
    called = began;
    return MappedCall.of(asked.get(), outcome -> {
      tally.answered(outcome instanceof CallOutcome.Failed<ActionReply> failed ? Optional.of(failed.reason())
          : Optional.empty(), began);
      return outcome;
    });
  }

  private BridgeStatus measured() {
    if (open.isEmpty()) {
      return status(State.WAITING, OpenWay.missing(ends, surroundings));
    }
    Optional<String> missing = open.get().missing();
    if (missing.isPresent()) {
      return status(State.WAITING, missing.get());
    }
    Optional<String> refusal = tally.refusal().filter(reason -> System.nanoTime() - called < RECENT);
    if (refusal.isPresent()) {
      return status(State.REFUSED, refusal.get());
    }
    return status(offered.stands() ? State.CARRYING : State.WAITING, offered.text());
  }

  private BridgeStatus status(State state, String text) {
    Counts counts = new Counts(received.get(), tally.passed(), 0, 0, tally.refused());
    return new BridgeStatus(config.name(), ends.from(), ends.to(), state, text, counts, tally.rateHz(),
        tally.lagSeconds(), open.flatMap(route -> route.robot().holder()));
  }

  @Override
  public void close() {
    open.ifPresent(ServiceRoute::close);
    open = Optional.empty();
    offered = Offered.NOT_YET;
    due = System.nanoTime();
  }
}
