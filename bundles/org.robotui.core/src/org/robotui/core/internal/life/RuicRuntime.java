package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.robotui.api.RuicType;
import org.robotui.api.Uic;
import org.robotui.api.alert.AlertBoard;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Principal;
import org.robotui.api.host.ConfigChange;
import org.robotui.api.host.Exchange;
import org.robotui.api.host.ExchangeOutcome;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicSnapshot;
import org.robotui.api.host.RuicState;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.ShowChoice;
import org.robotui.api.show.Subject;
import org.robotui.api.time.RobotClock;
import org.robotui.core.internal.config.model.ComponentConfig;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.time.RuicClock;
import org.robotui.core.internal.time.RuicFrames;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One RUIC and its life. All changes happen on its worker, one after the other; everything else only asks for them. */
public final class RuicRuntime implements Ruic, RuicParts.Wake {
  private static final Logger LOG = LoggerFactory.getLogger(RuicRuntime.class);
  private static final Duration CLOSE_LIMIT = Duration.ofSeconds(2);

  private final AtomicReference<RuicConfig> config;
  private final Services services;
  private final RuicWorker worker;
  private final RuicFrames frames;
  private final RuicClock clock;
  private final RuicAlerts alerts;
  private final SelectedRobots selection = new SelectedRobots();
  private final RuicOverlay overlay;
  private final Components components;
  private final RuicRobots robots;
  private final Wiring wiring;
  private final LateViews lateViews;
  private final Set<String> windows = ConcurrentHashMap.newKeySet();
  private final RuicInterfaces interfaces;
  private final Showings showings;
  private Optional<RuicType> plannedWith = Optional.empty(); // only on the worker
  private boolean wasSelected; // only on the worker
  private boolean waits; // until it is shown; only on the worker
  private boolean stands; // its components were made; only on the worker
  private final ArrangedViews arranged;
  private volatile Health health = Health.ADDED;

  public RuicRuntime(RuicConfig config, RuicOverlay overlay, Services services) {
    this.overlay = overlay;
    this.services = services;
    this.config = new AtomicReference<>(new Written(services.check()).withChosen(config, overlay));
    this.worker = new RuicWorker("ruic-" + config.name());
    this.frames = new RuicFrames(config.frames());
    this.waits = config.startsShown();
    this.clock = new RuicClock(services.clock(), services.wall(), frames::clear);
    this.alerts = RuicAlerts.of(config, services);
    TrackedThreads threads = new TrackedThreads(config.name(), (t, e) -> LOG.error("{} ended", t.getName(), e));
    RuicParts parts =
        new RuicParts(this.config::get, this, services, worker.serial(), threads, clock, frames, alerts, overlay, this);
    this.components = new Components(parts);
    this.robots = new RuicRobots(this.config::get, services, components);
    this.wiring = new Wiring(parts, components, this::tell);
    this.lateViews = new LateViews(services, components, worker::run, this::started);
    this.interfaces = new RuicInterfaces(parts, this.config, new AtomicReference<>(config), components, robots, wiring);
    this.arranged = new ArrangedViews(parts, wiring, this::rearranged);
    this.showings = new Showings(services, components, arranged);
  }

  /** Creates all components; of a RUIC that starts when it is shown, then. */
  public void initialize() {
    robots.register(); // at once: who may command is asked for at once
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
  private void rearranged() {
    tell();
    worker.run(() -> {
      if (stands) {
        components.rearrange(arranged.running(), robots::first).forEach(l -> services.events().alert(name(), l));
        started();
      }
    });
  }

  private void set(Health now) {
    health = now;
    tell();
  }

  private void tell() {
    services.events().changed(name());
  }

  /** Component types have come or gone. Completes when that is taken up: when nothing of a type that has gone runs. */
  public CompletableFuture<Void> typesChanged() {
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

  private void applySelection() {
    if (health.isFailed()) {
      return;
    }
    boolean selected = !windows.isEmpty();
    wasSelected |= selected;
    components.shown().forEach(s -> s.select(selected));
    set(new Health(selected ? RuicState.SELECTED : wasSelected ? RuicState.UNSELECTED : RuicState.INITIALIZED, ""));
  }

  private List<String> end(Duration limit) {
    plannedWith = Optional.empty();
    stands = false;
    try {
      List<String> left = components.close(limit);
      left.forEach(l -> services.events().alert(name(), l));
      return left;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return List.of(name() + ": closing was interrupted");
    } finally {
      wiring.clear();
      frames.reset();
    }
  }

  @Override
  public CompletionStage<RuicState> restart() {
    return worker.ask(() -> {
      end(CLOSE_LIMIT);
      set(Health.ADDED);
      interfaces.takeUpFile();
      create();
      return health.state();
    }, RuicState.SHUT_DOWN);
  }

  @Override
  public void restart(String id) {
    worker.run(() -> components.find(id).ifPresent(slot -> {
      slot.restart();
      started();
    }));
  }

  private void started() {
    wiring.rematch();
    applySelection();
    tell();
  }

  @Override
  public CompletionStage<RuicState> remove() {
    return shutDown(CLOSE_LIMIT).thenApply(left -> RuicState.SHUT_DOWN);
  }

  public CompletionStage<List<String>> shutDown(Duration limit) {
    worker.run(() -> {
      List<String> left = end(limit);
      robots.unregister();
      set(new Health(RuicState.SHUT_DOWN, ""));
      worker.end(() -> services.events().removed(this), left);
    });
    return worker.ended();
  }

  public int running() {
    return components.rfics().size();
  }

  @Override
  public PortAccess access(Principal principal) {
    return new ProgramAccess(components, services, robots::first, principal);
  }

  @Override
  public List<InterfaceConfig> interfaces() {
    return interfaces.all();
  }

  @Override
  public Optional<InterfaceConfig> written(String id) {
    return interfaces.inFile(id);
  }

  @Override
  public Exchange exchange(InterfaceConfig wanted) {
    return interfaces.trial(wanted, this::exchange);
  }

  private CompletionStage<ExchangeOutcome> exchange(ComponentConfig next, Map<SourceId, SourceId> connections) {
    return worker.ask(() -> {
      ExchangeOutcome outcome = interfaces.exchange(next, connections);
      tell();
      return outcome;
    }, new ExchangeOutcome.Refused(name() + " has ended"));
  }

  public RuicConfig config() {
    return config.get();
  }

  public boolean isOf(String file) {
    return config.get().file().equals(file);
  }

  public List<ConfigChange.Step> fileChanged(RuicConfig latest) {
    return interfaces.fileChanged(latest);
  }

  @Override
  public void failed(Object instance, String reason) {
    onComponents(() -> components.failed(instance, reason));
  }

  @Override
  public void late(UicInstance instance, Duration limit) {
    onComponents(() -> lateViews.late(instance, limit));
  }

  @Override
  public void surfaceFailed(String id, String reason) {
    onComponents(() -> components.surfaceFailed(id, reason));
  }

  private void onComponents(BooleanSupplier change) {
    worker.run(() -> {
      if (change.getAsBoolean()) {
        wiring.rematch();
        tell();
      }
    });
  }

  @Override
  public void rematch() {
    wiring.request();
  }

  @Override
  public void linkChanged() {
    robots.recheck();
    wiring.request();
    tell();
  }

  @Override
  public List<ShowChoice> showChoices(Subject subject) {
    return showings.choices(subject);
  }

  @Override
  public void show(ShowChoice choice, Subject subject) {
    showings.show(name(), choice, subject, worker::run);
  }

  @Override
  public Optional<Envelope<?>> newest(SourceId port) {
    return showings.newest(port);
  }

  @Override
  public void connect(SourceId port, SourceId peer) {
    overlay.connect(port, peer);
    wiring.request();
  }

  @Override
  public void select(String window) {
    change(set -> set.add(window));
  }

  @Override
  public void unselect(String window) {
    change(set -> set.remove(window));
  }

  private void change(Consumer<Set<String>> how) {
    worker.run(() -> {
      how.accept(windows);
      if (waits && !windows.isEmpty()) {
        create();
      } else if (!waits) {
        applySelection();
      }
    });
  }

  @Override
  public boolean startsShown() {
    return config.get().startsShown();
  }

  @Override
  public String name() {
    return config.get().name();
  }

  @Override
  public RuicSnapshot snapshot() {
    return Snapshots.of(name(), health, components, wiring.matches(), services.clock());
  }

  @Override
  public List<Authority> authorities() {
    return robots.authorities();
  }

  @Override
  public Optional<Authority> authority(String component) {
    return robots.authority(component);
  }

  @Override
  public SelectedRobots selection() {
    return selection;
  }

  @Override
  public AlertBoard alerts() {
    return alerts;
  }

  @Override
  public void reset() {
    clock.forgetPast();
  }

  @Override
  public RobotClock clock() {
    return clock;
  }

  @Override
  public ArrangedViews arranging() {
    return arranged;
  }

  @Override
  public Optional<Uic> uic(String id) {
    return components.uic(id).flatMap(UicSlot::uic);
  }

  @Override
  public String title(String id) {
    return arranged.title(id).orElse(id);
  }
}
