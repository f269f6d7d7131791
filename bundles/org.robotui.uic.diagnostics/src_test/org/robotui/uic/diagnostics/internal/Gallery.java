package org.robotui.uic.diagnostics.internal;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.SashForm;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.status.Diagnostics;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.GalleryWindow;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;

/** Shows the view in all its states side by side, for a person to look at: {@code Gallery dark|light}. */
final class Gallery {
  private static final SourceId SORTED = new SourceId("base", "/diagnostics_agg");
  private static final long SECOND = 1_000_000_000L;
  private static final int MINUTES = 10;

  private final GalleryWindow window;
  private final Theme theme;
  private final long now = System.nanoTime();

  private Gallery(GalleryWindow window, Theme theme) {
    this.window = window;
    this.theme = theme;
  }

  public static void main(String[] arguments) {
    GalleryWindow.show(display -> Themes.of(display, arguments[0]), theme -> theme.color(Role.LINE),
        (window, theme) -> new Gallery(window, theme).fill());
  }

  private void fill() {
    cell(0, 0, 1000, 500, c -> c.settings().set(DiagnosticsType.OPENED,
        List.of("base./diagnostics_agg/Robot/Base", "base./diagnostics_agg/Robot/Sensors")), true);
    press(0, 300, 78);
    cell(1006, 0, 594, 247, c -> c.input(DiagnosticsType.DIAGNOSTICS).state(
        new InputState.Unconnected("diagnostics needs Diagnostics; base offers none.")), false);
    cell(1006, 253, 594, 247, c -> c.input(DiagnosticsType.DIAGNOSTICS).state(
        new InputState.Waiting("/diagnostics has 3 publishers, nothing came yet")), false);
    cell(0, 506, 560, 494, c -> c.settings().set(DiagnosticsType.PROBLEMS, true), true);
    press(3, 420, 62);
    cell(566, 506, 560, 244, c -> {}, true,
        c -> c.input(DiagnosticsType.DIAGNOSTICS).state(new InputState.Stale(12.3, "the link is lost")));
    cell(566, 756, 560, 244, c -> c.settings().set(DiagnosticsType.PROBLEMS, true), false,
        c -> c.input(DiagnosticsType.DIAGNOSTICS).put(
            SORTED, new Diagnostics(List.of(item("/Robot/Motor", Diagnostics.Level.OK, "fine"))), now,
            Optional.empty()));
    cell(1132, 506, 300, 494, c -> {}, true);
    cell(1438, 506, 162, 494, c -> {}, true);
  }

  private void press(int part, int x, int y) {
    Control list = tree(window.made(part)).orElseThrow();
    Event down = new Event();
    down.button = 1;
    down.x = x;
    down.y = y;
    list.notifyListeners(SWT.MouseDown, down);
  }

  /** The tree is the first that has a scroll bar. */
  private static Optional<Control> tree(Control control) {
    if (control instanceof Canvas && (control.getStyle() & SWT.V_SCROLL) != 0 && !(control instanceof SashForm)) {
      return Optional.of(control);
    }
    if (control instanceof Composite composite) {
      for (Control child : composite.getChildren()) {
        Optional<Control> found = tree(child);
        if (found.isPresent()) {
          return found;
        }
      }
    }
    return Optional.empty();
  }

  private void live(FakeUicContext context, DiagnosticsUic uic) {
    for (int second = MINUTES * 60; second >= 0; second--) {
      long at = now - second * SECOND;
      if (second < 540) {
        context.input(DiagnosticsType.DIAGNOSTICS).put(SORTED, new Diagnostics(report(second)), at, Optional.empty());
      }
      uic.tick(at);
    }
  }

  private static List<Diagnostics.Item> report(int ago) {
    List<Diagnostics.Item> items = new java.util.ArrayList<>();
    double heat = 46 + 20 * Math.sin(ago / 60.0);
    boolean hot = heat > 60;
    items.add(item("/Robot/Base/Motor left", hot ? Diagnostics.Level.WARNING : Diagnostics.Level.OK,
        hot ? "Temperature high" : "OK",
        "Temperature", String.format(java.util.Locale.ROOT, "%.1f C", heat), "Current", "1.32 A", "Voltage", "24.1 V",
        "Encoder", "182113",
        "Firmware", "2.4.1", "Errors since start", "0"));
    items.add(item("/Robot/Base/Motor right", Diagnostics.Level.OK, "OK", "Temperature", "44.0 C"));
    items.add(item("/Robot/Base/Battery", Diagnostics.Level.OK, "87 %", "Charge", "87 %"));
    if (ago > 20) {
      items.add(item("/Robot/Sensors/Laser front", ago % 200 < 25 ? Diagnostics.Level.ERROR : Diagnostics.Level.OK,
          ago % 200 < 25 ? "No data from device /dev/ttyACM0" : "Streaming", "Rate", "40 Hz"));
    }
    items.add(item("/Robot/Sensors/Camera", Diagnostics.Level.ERROR,
        "Desired frequency not met: 3.1 Hz instead of 30 Hz", "Rate", "3.1 Hz"));
    items
        .add(item("/Robot/Computer/CPU", ago % 97 < 6 ? Diagnostics.Level.WARNING : Diagnostics.Level.OK, "Load 0.61"));
    items.add(item("/Robot/Computer/Disk", Diagnostics.Level.OK, "41 GB free"));
    items.add(item("/Robot/Computer/Clock", Diagnostics.Level.OK, "Offset 3 us"));
    items.add(item("/Other/arm_driver: Joint 1", Diagnostics.Level.OK, "Homed"));
    return items;
  }

  private static Diagnostics.Item item(String name, Diagnostics.Level level, String message, String... values) {
    Map<String, String> details = new LinkedHashMap<>();
    for (int i = 0; i < values.length; i += 2) {
      details.put(values[i], values[i + 1]);
    }
    return new Diagnostics.Item(name, "roboteq-2", level, message, details);
  }

  private void cell(int x, int y, int width, int height, Consumer<FakeUicContext> before, boolean live) {
    cell(x, y, width, height, before, live, c -> {});
  }

  private void cell(int x, int y, int width, int height, Consumer<FakeUicContext> before, boolean live,
      Consumer<FakeUicContext> after) {
    FakeUicContext context = new FakeUicContext("diagnostics", new DiagnosticsType().schema());
    before.accept(context);
    Composite part = window.cell(x, y, width, height);
    DiagnosticsUic uic = new DiagnosticsUic(context);
    if (live) {
      live(context, uic);
    }
    after.accept(context);
    uic.tick(now + 1);
    uic.createControl(part, UiContext.of(theme, part::setData));
    part.layout(true, true);
    uic.refresh();
    Display.getCurrent().timerExec(600 + x, () -> {
      uic.tick(now + 2);
      uic.refresh();
    });
  }
}
