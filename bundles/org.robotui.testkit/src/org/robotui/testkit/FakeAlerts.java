package org.robotui.testkit;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.alert.Alert;
import org.robotui.api.alert.AlertBoard;
import org.robotui.api.alert.AlertEvent;
import org.robotui.api.alert.AlertId;
import org.robotui.api.alert.AlertSource;

/** Alerts of a view called sound, without a clock: a mute lasts until it is taken back. Safe for all threads. */
public final class FakeAlerts implements AlertBoard, AlertSource {
  /** The view whose alerts they are. */
  public static final String VIEW = "sound";

  private final Map<AlertId, Alert> alerts = new LinkedHashMap<>();
  private final Deque<AlertEvent> history = new ArrayDeque<>();
  private Optional<Instant> muted = Optional.empty();

  /**
   * Lists an alert as it is, in place of an earlier one.
   *
   * @param alert the alert
   */
  public synchronized void show(Alert alert) {
    alerts.put(alert.id(), alert);
  }

  /**
   * An alert of the view.
   *
   * @param name its name
   * @return the alert as it is now, or none
   */
  public synchronized Optional<Alert> find(String name) {
    return Optional.ofNullable(alerts.get(new AlertId(VIEW, name)));
  }

  /**
   * Has something happened.
   *
   * @param event what
   */
  public synchronized void happened(AlertEvent event) {
    history.addFirst(event);
  }

  @Override
  public synchronized List<AlertEvent> history() {
    return List.copyOf(history);
  }

  @Override
  public synchronized List<Alert> alerts() {
    return List.copyOf(alerts.values());
  }

  @Override
  public synchronized void raise(String name, String condition, String source, String value) {
    AlertId id = new AlertId(VIEW, name);
    Optional<Alert> before = find(name).filter(Alert::lasting);
    show(new Alert(id, condition, source, value, before.map(Alert::since).orElse(Instant.EPOCH), 1, true,
        before.map(Alert::acknowledged).orElse(false), find(name).flatMap(Alert::mutedUntil)));
  }

  @Override
  public synchronized void end(String name) {
    find(name).ifPresent(a -> show(state(a, false, a.acknowledged(), a.mutedUntil())));
  }

  @Override
  public synchronized boolean isHeard(String name) {
    return muted.isEmpty() && find(name).map(a -> !a.acknowledged() && a.mutedUntil().isEmpty()).orElse(true);
  }

  @Override
  public synchronized void acknowledge(AlertId alert) {
    alerts.computeIfPresent(alert, (id, a) -> state(a, a.lasting(), true, a.mutedUntil()));
  }

  @Override
  public synchronized void mute(AlertId alert, Optional<Instant> until) {
    alerts.computeIfPresent(alert, (id, a) -> state(a, a.lasting(), a.acknowledged(), until));
  }

  @Override
  public synchronized void muteAll(Optional<Instant> until) {
    muted = until;
  }

  @Override
  public synchronized Optional<Instant> allMutedUntil() {
    return muted;
  }

  private static Alert state(Alert a, boolean lasting, boolean acknowledged, Optional<Instant> until) {
    return new Alert(a.id(), a.condition(), a.source(), a.value(), a.since(), a.times(), lasting, acknowledged, until);
  }
}
