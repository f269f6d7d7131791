package org.robotui.core.internal.life;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import org.robotui.api.Uic;
import org.robotui.api.alert.AlertBoard;
import org.robotui.api.command.Authority;
import org.robotui.api.command.Principal;
import org.robotui.api.config.SettingsStore;
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
  private final RuicInterfaces interfaces;
  private final Showings showings;
  private final ArrangedViews arranged;
  private final RuicLife life;

  public RuicRuntime(RuicConfig config, RuicOverlay overlay, Services services) {
    this.overlay = overlay;
    this.services = services;
    this.config = new AtomicReference<>(new Written(services.check()).withChosen(config, overlay));
    this.worker = new RuicWorker("ruic-" + config.name());
    this.frames = new RuicFrames(config.frames());
    this.clock = new RuicClock(services.clock(), services.wall(), frames::clear);
    this.alerts = RuicAlerts.of(config, services);
    TrackedThreads threads = new TrackedThreads(config.name(), (t, e) -> LOG.error("{} ended", t.getName(), e));
    RuicParts parts =
        new RuicParts(this.config::get, this, services, worker.serial(), threads, clock, frames, alerts, overlay, this);
    this.components = new Components(parts);
    this.robots = new RuicRobots(this.config::get, services, components);
    this.wiring = new Wiring(parts, components, this::tell);
    this.lateViews = new LateViews(services, components, worker::run, () -> life().started());
    this.interfaces = new RuicInterfaces(parts, this.config, new AtomicReference<>(config), components, robots, wiring);
    this.arranged = new ArrangedViews(parts, wiring, () -> life().rearranged());
    this.showings = new Showings(services, components, arranged);
    this.life = new RuicLife(this.config::get, services, worker, components, robots, wiring, arranged, frames);
  }

  /** For those that are made before it and are used later. */
  private RuicLife life() {
    return life;
  }

  /** Creates all components; of a RUIC that starts when it is shown, then. */
  public void initialize() {
    robots.register(); // at once: who may command is asked for at once
    life.initialize();
  }

  private void tell() {
    services.events().changed(name());
  }

  /** Component types have come or gone. Completes when that is taken up: when nothing of a type that has gone runs. */
  public CompletableFuture<Void> typesChanged() {
    return life.typesChanged();
  }

  @Override
  public CompletionStage<RuicState> restart() {
    return life.restart(interfaces::takeUpFile);
  }

  @Override
  public void restart(String id) {
    worker.run(() -> components.find(id).ifPresent(slot -> {
      slot.restart();
      life.started();
    }));
  }

  @Override
  public CompletionStage<RuicState> remove() {
    return shutDown(RuicLife.CLOSE_LIMIT).thenApply(left -> RuicState.SHUT_DOWN);
  }

  /**
   * Ends all components, and its worker.
   *
   * @param limit how long that may take
   * @return completes with what could not be ended, a sentence each
   */
  public CompletionStage<List<String>> shutDown(Duration limit) {
    return life.shutDown(limit, () -> services.events().removed(this));
  }

  /** How many robot interfaces run. */
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

  /** As it runs now: with what users have exchanged and chosen. */
  public RuicConfig config() {
    return config.get();
  }

  /** Whether it stands in that file. */
  public boolean isOf(String file) {
    return config.get().file().equals(file);
  }

  /** The file says something else now: what would have to be done to follow it. */
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
  public Optional<Envelope<?>> sent(SourceId port) {
    return showings.sent(port);
  }

  @Override
  public void connect(SourceId port, SourceId peer) {
    overlay.connect(port, peer);
    wiring.request();
  }

  @Override
  public void select(String window) {
    life.show(windows -> windows.add(window));
  }

  @Override
  public void unselect(String window) {
    life.show(windows -> windows.remove(window));
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
    return Snapshots.of(name(), life.health(), components, wiring.matches(), services.clock());
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
  public Optional<SettingsStore> settings(String id) {
    return components.uic(id).flatMap(UicSlot::settings);
  }

  @Override
  public long ticks(String id) {
    return components.uic(id).map(UicSlot::ticks).orElse(0L);
  }

  @Override
  public String title(String id) {
    return arranged.title(id).orElse(id);
  }
}
