package org.robotui.core.internal.life;

import java.nio.file.Path;
import java.time.Instant;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.alert.Alert;
import org.robotui.api.alert.AlertBoard;
import org.robotui.api.alert.AlertEvent;
import org.robotui.api.alert.AlertEvent.Kind;
import org.robotui.api.alert.AlertId;
import org.robotui.api.alert.AlertSource;
import org.robotui.core.internal.config.model.KeptAlerts;
import org.robotui.core.internal.config.model.RuicConfig;
import org.robotui.core.internal.time.WallClock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The alerts of one RUIC. Each begins, is over, and goes once somebody has acknowledged it. */
final class RuicAlerts implements AlertBoard {
  private static final Logger LOG = LoggerFactory.getLogger(RuicAlerts.class);
  /** A view that names every alert differently must not fill the memory. */
  static final int MOST = 200;
  private static final AlertId ALL = new AlertId("", "");
  private static final long NANOS = 1_000_000_000L;
  private static final Comparator<Alert> ORDER = Comparator.comparing(Alert::acknowledged)
      .thenComparing(alert -> !alert.lasting()).thenComparing(Alert::since, Comparator.reverseOrder());

  private final WallClock clock;
  private final Map<AlertId, Alert> alerts = new LinkedHashMap<>(); // under the lock, as all below
  private final Map<AlertId, Instant> muted; // in the order of muting
  private final AlertHistory history;
  private final Supplier<String> user;
  private final AlertStore store;
  private Optional<Instant> allMuted;

  /**
   * With what was kept.
   *
   * @param clock this machine's
   * @param user who acknowledges and mutes
   * @param store where that is kept
   */
  RuicAlerts(WallClock clock, Supplier<String> user, AlertStore store) {
    this.clock = clock;
    this.user = user;
    this.store = store;
    KeptAlerts kept = store.read();
    this.muted = new LinkedHashMap<>(kept.muted());
    this.history = new AlertHistory(kept.history());
    this.allMuted = kept.allMuted();
  }

  /** Those of a RUIC, with what was kept of them beside the files of its robot interfaces. */
  static RuicAlerts of(RuicConfig config, Services services) {
    Path file = AlertStore.file(services.stateFolder().resolveSibling("alerts"), config.file(), config.name());
    return new RuicAlerts(services.wall(), () -> services.stage().get().principal().label(),
        new AlertStore(file, services.timer()));
  }

  /** Writes what was not written yet. Blocks for the file. */
  void save() {
    store.save(this::kept);
  }

  private synchronized KeptAlerts kept() {
    muted.values().removeIf(when -> !isToCome(when));
    return new KeptAlerts(new LinkedHashMap<>(muted), allMutedUntil(), history.all());
  }

  @Override
  public synchronized List<AlertEvent> history() {
    return history.all().reversed();
  }

  /** Something was done by the user. */
  private void did(AlertId id, Kind kind, String value) {
    history.add(new AlertEvent(now(), id, kind, "", value, user.get()));
    store.changed(this::kept);
  }

  private void happened(AlertId id, Kind kind, String source, String value) {
    history.happened(new AlertEvent(now(), id, kind, source, value, ""));
    store.changed(this::kept);
  }

  /** Where a view says its own. */
  AlertSource source(String view) {
    return new Source(view);
  }

  /**
   * The view is there no more: nobody watches what it watched. It may be the end of all, so that the file is written.
   */
  void forget(String view) {
    synchronized (this) {
      alerts.keySet().removeIf(id -> id.view().equals(view));
    }
    save(); // without the lock of the board, which those that save take after that of the file
  }

  @Override
  public synchronized List<Alert> alerts() {
    return alerts.values().stream().map(this::withMute).sorted(ORDER).toList();
  }

  private Alert withMute(Alert a) {
    return new Alert(a.id(), a.condition(), a.source(), a.value(), a.since(), a.times(), a.lasting(), a.acknowledged(),
        Optional.ofNullable(muted.get(a.id())).filter(this::isToCome));
  }

  @Override
  public synchronized void acknowledge(AlertId id) {
    Alert alert = alerts.get(id);
    if (alert == null || alert.acknowledged()) {
      return;
    }
    if (alert.lasting()) {
      alerts.put(id, state(alert, true, true));
    } else {
      alerts.remove(id);
    }
    did(id, Kind.ACKNOWLEDGED, "");
  }

  @Override
  public synchronized void mute(AlertId alert, Optional<Instant> until) {
    muted.values().removeIf(when -> !isToCome(when));
    boolean wasMuted = muted.remove(alert) != null;
    Optional<Instant> next = until.filter(this::isToCome);
    if (next.isPresent() || wasMuted) {
      did(alert, next.isPresent() ? Kind.MUTED : Kind.UNMUTED, next.map(Instant::toString).orElse(""));
    }
    until.filter(this::isToCome).ifPresent(when -> {
      keepRoom();
      muted.put(alert, when);
    });
  }

  /**
   * No more are listed than can be muted, so those that nobody sees go first: what is listed stays muted as it says.
   */
  private void keepRoom() {
    if (muted.size() >= MOST) {
      Comparator<Map.Entry<AlertId, Instant>> order = Comparator.comparing(entry -> alerts.containsKey(entry.getKey()));
      muted.entrySet().stream().min(order.thenComparing(Map.Entry::getValue)).map(Map.Entry::getKey)
          .ifPresent(this::letBeHeard);
    }
  }

  private void letBeHeard(AlertId alert) {
    LOG.warn("{} can be heard again: {} others are muted, and no more can be", alert, MOST);
    muted.remove(alert);
  }

  @Override
  public synchronized void muteAll(Optional<Instant> until) {
    boolean wasMuted = allMutedUntil().isPresent();
    allMuted = until;
    Optional<Instant> next = allMutedUntil();
    if (next.isPresent() || wasMuted) {
      did(ALL, next.isPresent() ? Kind.MUTED : Kind.UNMUTED, next.map(Instant::toString).orElse(""));
    }
  }

  @Override
  public synchronized Optional<Instant> allMutedUntil() {
    return allMuted.filter(this::isToCome);
  }

  private boolean isToCome(Instant when) {
    return when.isAfter(now());
  }

  private Instant now() {
    long nanos = clock.nanos();
    return Instant.ofEpochSecond(nanos / NANOS, nanos % NANOS);
  }

  private synchronized void raise(AlertId id, String condition, String source, String value) {
    Alert before = alerts.get(id);
    if (before != null && before.lasting()) {
      alerts.put(id, new Alert(id, condition, source, value, before.since(), before.times(), true,
          before.acknowledged(), Optional.empty()));
    } else {
      int times = before == null ? 1 : before.times() + 1;
      alerts.put(id, new Alert(id, condition, source, value, now(), times, true, false, Optional.empty()));
      dropOldest();
      happened(id, Kind.BEGAN, source, value);
    }
  }

  private void dropOldest() {
    if (alerts.size() > MOST) {
      alerts.values().stream().min(Comparator.comparing(Alert::lasting).thenComparing(Alert::since)).map(Alert::id)
          .ifPresent(alerts::remove);
    }
  }

  private synchronized void end(AlertId id) {
    Alert alert = alerts.get(id);
    if (alert == null || !alert.lasting()) {
      return;
    }
    if (alert.acknowledged()) {
      alerts.remove(id);
    } else {
      alerts.put(id, state(alert, false, false));
    }
    happened(id, Kind.ENDED, "", "");
  }

  private synchronized boolean isHeard(AlertId id) {
    boolean seen = alerts.containsKey(id) && alerts.get(id).acknowledged();
    boolean silent = muted.containsKey(id) && isToCome(muted.get(id));
    return !seen && !silent && allMutedUntil().isEmpty();
  }

  private static Alert state(Alert a, boolean lasting, boolean acknowledged) {
    return new Alert(a.id(), a.condition(), a.source(), a.value(), a.since(), a.times(), lasting, acknowledged,
        Optional.empty());
  }

  /** The alerts of one view. */
  private final class Source implements AlertSource {
    private final String view;

    Source(String view) {
      this.view = view;
    }

    @Override
    public void raise(String name, String condition, String source, String value) {
      RuicAlerts.this.raise(new AlertId(view, name), condition, source, value);
    }

    @Override
    public void end(String name) {
      RuicAlerts.this.end(new AlertId(view, name));
    }

    @Override
    public boolean isHeard(String name) {
      return RuicAlerts.this.isHeard(new AlertId(view, name));
    }
  }
}
