package org.robotui.uic.status.internal;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.sensor.Battery;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.GalleryWindow;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;

/** Shows the view in all its states side by side, for a person to look at: {@code Gallery dark|light}. */
record Gallery(GalleryWindow window, Theme theme) {
  public static void main(String[] arguments) {
    GalleryWindow.show(display -> Themes.of(display, arguments[0]), theme -> theme.color(Role.LINE),
        (window, theme) -> new Gallery(window, theme).fill());
  }

  private void fill() {
    cell(0, 0, 780, 500, Gallery::typical);
    cell(786, 0, 560, 300, c -> {
      typical(c);
      c.authority().stop(FakeAuthority.YOU);
    });
    cell(1352, 0, 248, 300, Gallery::typical);
    cell(786, 306, 560, 194, c -> {
      typical(c);
      c.settings().set(StatusType.CONNECTIONS, true);
    });
    cell(0, 506, 560, 240, c -> c.ruic().snapshot(Snapshots.of(
        new LinkState.Failed("localhost:11311 refuses the connection", Duration.ofSeconds(4)), List.of(), List.of())));
    cell(566, 506, 560, 240, c -> {});
    cell(1132, 506, 460, 240,
        c -> c.ruic().snapshot(Snapshots.of(new LinkState.Connecting("localhost:11311"), List.of(), List.of())));
  }

  private static void typical(FakeUicContext context) {
    context.ruic().snapshot(Snapshots.typical());
    battery(context, "/battery", 0.87);
    battery(context, "/arm/battery", 0.18);
    context.input(StatusType.BATTERY).state(new SourceId("base", "/gripper/battery"),
        new InputState.Waiting("no data yet"));
  }

  private static void battery(FakeUicContext context, String port, double charge) {
    context.input(StatusType.BATTERY).put(new SourceId("base", port),
        new Battery(14.1, -1.2, charge, Battery.Status.DISCHARGING), System.nanoTime(), Optional.empty());
  }

  private void cell(int x, int y, int width, int height, Consumer<FakeUicContext> prepare) {
    FakeUicContext context = new FakeUicContext("status", new StatusType().schema());
    prepare.accept(context);
    Composite part = window.cell(x, y, width, height);
    StatusUic uic = new StatusUic(context);
    uic.tick(System.nanoTime());
    uic.createControl(part, UiContext.of(theme, part::setData));
    part.layout(true, true);
  }
}
