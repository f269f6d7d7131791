package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Ends views that took too long to answer, and starts them again after a pause: on a machine that is starved, they did
 * nothing wrong. Never while the thread of the one before has not ended, so that a view that really hangs holds one
 * thread, and not one more with each try. On the worker of the RUIC.
 */
final class LateViews {
  private static final Logger LOG = LoggerFactory.getLogger(LateViews.class);

  private final Services services;
  private final Components components;
  private final Executor worker;
  private final Runnable started;

  /**
   * For the views of a RUIC.
   *
   * @param services of the host
   * @param components of the RUIC
   * @param worker of the RUIC, as long as it lives
   * @param started connects what was started again
   */
  LateViews(Services services, Components components, Executor worker, Runnable started) {
    this.services = services;
    this.components = components;
    this.worker = worker;
    this.started = started;
  }

  /** An instance took too long; true where it still runs. */
  boolean late(UicInstance instance, Duration limit) {
    Optional<UicSlot> slot =
        components.shown().stream().filter(s -> s.instance().filter(i -> i == instance).isPresent()).findFirst();
    slot.ifPresent(s -> {
      LOG.warn("{} did not return from tick within {} s ({})", s.id(), limit.toSeconds(), instance.origin());
      plan(s, instance, named(s) + " took longer than " + limit.toSeconds() + " s to answer");
    });
    return slot.isPresent();
  }

  private void plan(UicSlot slot, UicInstance instance, String what) {
    Optional<Duration> pause = slot.revival().next(services.clock().nanos());
    String next = pause.map(p -> "; it is started again in " + p.toSeconds() + " s.")
        .orElse(", " + Revival.PAUSES.size() + " times in a row; it is not started again by itself" + bundle(instance)
            + ".");
    slot.endLate(what + next, instance);
    Health failed = slot.health();
    pause.ifPresent(p -> later(p, () -> again(slot, instance, failed)));
  }

  private String bundle(UicInstance instance) {
    return services.registry().bundle(instance.type()).map(b -> " (bundle " + b + ")").orElse("");
  }

  private void later(Duration pause, Runnable task) {
    services.timer().schedule(() -> worker.execute(task), pause.toNanos(), TimeUnit.NANOSECONDS);
  }

  /** Where nobody else has started or ended it meanwhile. */
  private void again(UicSlot slot, UicInstance before, Health failed) {
    if (slot.health() != failed || !components.shown().contains(slot)) {
      return;
    }
    if (before.isTicking()) {
      plan(slot, before, named(slot) + " still does not answer");
    } else {
      slot.start();
    }
    started.run();
  }

  /** Never by its title alone: some titles are plurals (Services, Joints), and some are names. */
  private static String named(UicSlot slot) {
    return "The view '" + slot.title() + "'";
  }
}
