package org.robotui.uic.alerts.internal;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.UicContext;
import org.robotui.api.alert.Alert;
import org.robotui.api.alert.AlertBoard;
import org.robotui.api.alert.AlertWords;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;

/** The view: the tick looks, the surface lists. */
final class AlertsUic extends SurfaceUic<AlertsSurface> implements AlertActions {
  private final UicContext context;
  private final AlertBoard board;
  private final Clock clock;
  private volatile Page page;

  AlertsUic(UicContext context, Clock clock) {
    this.context = context;
    this.board = context.ruic().alerts();
    this.clock = clock;
    this.page = look();
  }

  @Override
  public boolean tick(long nowNanos) {
    Page next = look();
    boolean changed = !next.equals(page);
    page = next;
    return changed;
  }

  @Override
  protected AlertsSurface open(Composite parent, UiContext ui) {
    return new AlertsSurface(parent, ui, this, new AlertWords(clock.getZone()));
  }

  @Override
  protected void refresh(AlertsSurface shown) {
    shown.show(page);
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("A", "Acknowledge the selected alerts"),
        new ViewKey("M", "Mute them, or unmute them"),
        new ViewKey("H", "Show the history, or the alerts again"));
  }

  @Override
  public void acknowledge(List<Alert> alerts) {
    alerts.forEach(alert -> board.acknowledge(alert.id()));
    now();
  }

  @Override
  public void mute(List<Alert> alerts, Optional<Long> minutes) {
    alerts.forEach(alert -> board.mute(alert.id(), until(minutes)));
    now();
  }

  @Override
  public void muteAll(Optional<Long> minutes) {
    board.muteAll(until(minutes));
    now();
  }

  Page page() {
    return page;
  }

  private void now() {
    page = look();
    refresh();
  }

  private Page look() {
    return new Page(board.alerts(), board.allMutedUntil(),
        Math.round(context.settings().current().number(AlertsType.SNOOZE)), board.history());
  }

  private Optional<Instant> until(Optional<Long> minutes) {
    return minutes.isEmpty() ? Optional.of(Instant.MAX)
        : minutes.filter(m -> m > 0).map(m -> clock.instant().plus(Duration.ofMinutes(m)));
  }
}
