package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.robotui.api.host.ExchangeOutcome;
import org.robotui.api.port.SourceId;
import org.robotui.core.internal.command.Arbiter;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.RuicConfig;

/**
 * Puts one robot interface in the place of another while everything else goes on. On the worker of the RUIC. The order
 * is what keeps it safe: the robot is stopped and nobody holds it before the old interface ends, the views are
 * disconnected before the reset, and the new interface starts after it, so that no view mixes the values of both.
 */
final class Exchanger {
  private static final Duration CLOSE_LIMIT = Duration.ofSeconds(2);

  private final RuicParts ruic;
  private final AtomicReference<RuicConfig> config;
  private final Components components;
  private final RuicRobots robots;
  private final Wiring wiring;

  Exchanger(RuicParts ruic, AtomicReference<RuicConfig> config, Components components, RuicRobots robots,
      Wiring wiring) {
    this.ruic = ruic;
    this.config = config;
    this.components = components;
    this.robots = robots;
    this.wiring = wiring;
  }

  /** Exchanges; where the new one cannot be started, the old one is started again. */
  ExchangeOutcome exchange(ComponentConfig next, Map<SourceId, SourceId> connections) {
    Optional<RficSlot> old = components.rfic(next.id());
    if (old.isEmpty()) { // it waits until it is shown, or its type is not there
      config.updateAndGet(c -> c.with(next));
      robots.register();
      return new ExchangeOutcome.Done();
    }
    ComponentConfig before = old.get().config();
    end(old.get());
    RficSlot fresh = start(next);
    if (fresh.health().isFailed()) {
      String reason = fresh.health().reason();
      end(fresh);
      start(before);
      wiring.rematch();
      return new ExchangeOutcome.WentBack(
          next.id() + " as " + next.type() + " " + reason + "; it is " + before.type() + " again");
    }
    connections.forEach(ruic.overlay()::connect);
    wiring.rematch();
    return new ExchangeOutcome.Done();
  }

  private void end(RficSlot slot) {
    Arbiter arbiter = ruic.services().arbiters().of(slot.config().robot());
    // Who held the stick of one robot must not find that he moves another.
    arbiter.holder().ifPresent(arbiter::giveBack);
    slot.close(CLOSE_LIMIT).ifPresent(left -> ruic.services().events().alert(ruic.config().name(), left));
    wiring.rematch();
    ruic.frames().reset();
    components.rfics()
        .forEach(other -> other.instance().filter(i -> other != slot).ifPresent(RficInstance::sayFixedFramesAgain));
    ruic.clock().reset();
  }

  private RficSlot start(ComponentConfig next) {
    config.updateAndGet(c -> c.with(next));
    RficSlot slot = components.replace(next);
    robots.register();
    slot.start();
    return slot;
  }
}
