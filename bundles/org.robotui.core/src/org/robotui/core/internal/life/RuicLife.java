package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.robotui.api.RuicType;
import org.robotui.api.host.RuicState;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.time.RuicFrames;

/**
 * The life cycle of a RUIC: its components are made, shown, made anew and ended. All of it happens on the worker of the
 * RUIC; methods return at once.
 */
final class RuicLife {
  static final Duration CLOSE_LIMIT = Duration.ofSeconds(2);

  private final Supplier<RuicConfig> config;
  private final Services services;
  private final RuicWorker worker;
  private final Components components;
  private final RuicRobots robots;
  private final Wiring wiring;
  private final ArrangedViews arranged;
  private final RuicFrames frames;
  private final Set<String> windows = ConcurrentHashMap.newKeySet();
  private Optional<RuicType> plannedWith = Optional.empty(); // only on the worker, as the next three
  private boolean wasSelected;
  private boolean waits; // until it is shown
  private boolean stands; // its components were made
  private volatile Health health = Health.ADDED;

  RuicLife(Supplier<RuicConfig> config, Services services, RuicWorker worker, Components components, RuicRobots robots,
      Wiring wiring, ArrangedViews arranged, RuicFrames frames) {
    this.config = config;
    this.services = services;
    this.worker = worker;
    this.components = components;
    this.robots = robots;
    this.wiring = wiring;
    this.arranged = arranged;
    this.frames = frames;
    this.waits = config.get().startsShown();
  }

  Health health() {
    return health;
  }

  /** Creates all components; of a RUIC that starts when it is shown, then. */
  void initialize() {
    worker.run(() -> {
      if (!waits) {
        create();
      }
    });
  }

  private void create() {
    waits = false;
    switch (Plan.of(config.get(), services.registry(), services.check())) {
      case Plan.Outcome.Impossible i -> set(Health.failed(i.reason()));
      case Plan.Outcome.Made m -> create(m.plan());
    }
  }

  private void create(Plan plan) {
    plannedWith = plan.type();
    arranged.plan(plan);
    components.start(config.get().rfics(), arranged.running(), robots::first);
    stands = true;
    wiring.rematch();
    set(Health.RUNNING);
    applySelection();
  }

  /** Applications lay out what there is at once; the views that come and go follow. */
  void rearranged() {
    tell();
    worker.run(() -> {
      if (stands) {
        components.rearrange(arranged.running(), robots::first).forEach(this::alert);
        started();
      }
    });
  }

  /** Component types have come or gone. Completes when that is taken up: when nothing of a type that has gone runs. */
  CompletableFuture<Void> typesChanged() {
    return worker.ask(() -> {
      takeUpTypes();
      return true;
    }, true).thenAccept(taken -> {});
  }

  private void takeUpTypes() {
    Optional<RuicType> type = services.registry().ruic(config.get().type());
    if (!waits && !config.get().type().isEmpty() && !type.equals(plannedWith)) {
      end(CLOSE_LIMIT);
      create();
    } else if (!waits && components.typesChanged()) {
      started();
    }
  }

  /** Shows it in other windows than before. */
  void show(Consumer<Set<String>> change) {
    worker.run(() -> {
      change.accept(windows);
      if (waits && !windows.isEmpty()) {
        create();
      } else if (!waits) {
        applySelection();
      }
    });
  }

  private void applySelection() {
    if (health.isFailed()) {
      return;
    }
    boolean selected = !windows.isEmpty();
    wasSelected |= selected;
    components.shown().forEach(s -> s.select(selected));
    set(new Health(selected ? RuicState.SELECTED : wasSelected ? RuicState.UNSELECTED : RuicState.INITIALIZED, ""));
  }

  /** Ends all components and makes new ones, as the configuration is after what is done between. */
  CompletionStage<RuicState> restart(Runnable between) {
    return worker.ask(() -> {
      end(CLOSE_LIMIT);
      set(Health.ADDED);
      between.run();
      create();
      return health.state();
    }, RuicState.SHUT_DOWN);
  }

  /** Components have been started: they are connected, and shown where the RUIC is. On the worker. */
  void started() {
    wiring.rematch();
    applySelection();
    tell();
  }

  /** Ends all components and the worker; completes with what could not be ended. */
  CompletionStage<List<String>> shutDown(Duration limit, Runnable gone) {
    worker.run(() -> {
      List<String> left = end(limit);
      robots.unregister();
      set(new Health(RuicState.SHUT_DOWN, ""));
      worker.end(gone, left);
    });
    return worker.ended();
  }

  private List<String> end(Duration limit) {
    plannedWith = Optional.empty();
    stands = false;
    try {
      List<String> left = components.close(limit);
      left.forEach(this::alert);
      return left;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return List.of(name() + ": closing was interrupted");
    } finally {
      wiring.clear();
      frames.reset();
    }
  }

  private void set(Health now) {
    health = now;
    tell();
  }

  private void tell() {
    services.events().changed(name());
  }

  private void alert(String message) {
    services.events().alert(name(), message);
  }

  private String name() {
    return config.get().name();
  }
}
