package org.robotui.uic.alerts.internal;

import java.time.Clock;
import java.time.Instant;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.alert.Alert;
import org.robotui.api.alert.AlertEvent;
import org.robotui.api.alert.AlertId;
import org.robotui.testkit.FakeAlerts;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.GalleryWindow;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.ui.control.QuietButton;

/** Shows the view in all its states side by side, for a person to look at: {@code Gallery dark|light}. */
record Gallery(GalleryWindow window, Theme theme) {
  private static final Instant NOW = Instant.now();

  public static void main(String[] arguments) {
    GalleryWindow.show(display -> Themes.of(display, arguments[0]), theme -> theme.color(Role.LINE),
        (window, theme) -> new Gallery(window, theme).fill());
  }

  private void fill() {
    cell(0, 0, 980, 320, Gallery::typical);
    cell(986, 0, 614, 320, alerts -> {
      typical(alerts);
      alerts.muteAll(Optional.of(NOW.plusSeconds(600)));
    });
    cell(0, 326, 380, 320, Gallery::typical);
    cell(386, 326, 560, 320, alerts -> {});
    cell(952, 326, 280, 320, alerts -> {
      typical(alerts);
      alerts.muteAll(Optional.of(Instant.MAX));
    });
    turn(cell(0, 652, 980, 300, Gallery::remembered));
    turn(cell(986, 652, 300, 300, Gallery::remembered));
    turn(cell(1292, 652, 308, 300, alerts -> {}));
  }

  /** Has the history shown. */
  private static void turn(Control view) {
    Control[] buttons = ((Composite) ((Composite) view).getChildren()[0]).getChildren();
    ((QuietButton) buttons[buttons.length - 1]).press();
  }

  private static void remembered(FakeAlerts alerts) {
    typical(alerts);
    happened(alerts, 90_000, "Motor hot", AlertEvent.Kind.BEGAN, "WARNING: 71 degrees", "");
    happened(alerts, 89_000, "Motor hot", AlertEvent.Kind.ACKNOWLEDGED, "", "anna@lab-3");
    happened(alerts, 800, "Motor hot", AlertEvent.Kind.ENDED, "", "");
    happened(alerts, 95, "Battery low", AlertEvent.Kind.BEGAN, "0.18", "");
    happened(alerts, 60, "", AlertEvent.Kind.MUTED, NOW.plusSeconds(600).toString(), "anna@lab-3");
    happened(alerts, 30, "", AlertEvent.Kind.UNMUTED, "", "anna@lab-3");
  }

  private static void happened(FakeAlerts alerts, long ago, String name, AlertEvent.Kind kind, String value,
      String by) {
    String source = kind == AlertEvent.Kind.BEGAN ? "battery.charge" : "";
    alerts.happened(new AlertEvent(NOW.minusSeconds(ago), new AlertId(FakeAlerts.VIEW, name), kind, source, value, by));
  }

  private static void typical(FakeAlerts alerts) {
    show(alerts, "Battery low", "battery charge < 0.2", "battery.charge", "0.18", 95, 1, true, false, Optional.empty());
    show(alerts, "scan stale", "scan stale", "scan", "nothing for 4.2 s", 4, 3, true, false,
        Optional.of(NOW.plusSeconds(300)));
    show(alerts, "Motor hot", "diagnostics motor >= WARNING", "Left motor driver",
        "WARNING: 71 degrees, current limited", 1800, 1, true, true,
        Optional.empty());
    show(alerts, "log >= ERROR", "log >= ERROR", "/move_base",
        "ERROR: Aborting because a valid plan could not be found", 61, 12, false, false,
        Optional.empty());
  }

  private static void show(FakeAlerts alerts, String name, String condition, String source, String value, long ago,
      int times, boolean lasting,
      boolean acknowledged, Optional<Instant> muted) {
    alerts.show(new Alert(new AlertId(FakeAlerts.VIEW, name), condition, source, value, NOW.minusSeconds(ago), times,
        lasting, acknowledged, muted));
  }

  private Control cell(int x, int y, int width, int height, Consumer<FakeAlerts> prepare) {
    FakeUicContext context = new FakeUicContext("alerts", AlertsType.SCHEMA);
    prepare.accept(context.alerts());
    Composite part = window.cell(x, y, width, height);
    AlertsUic uic = new AlertsUic(context, Clock.systemDefaultZone());
    uic.tick(System.nanoTime());
    Control view = uic.createControl(part, UiContext.of(theme, part::setData));
    part.layout(true, true);
    return view;
  }
}
