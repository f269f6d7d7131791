package org.robotui.uic.trip.internal;

import java.util.function.Consumer;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.port.InputState;
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
    cell(0, 0, Gallery::gone);
    cell(406, 0, c -> {
      gone(c);
      c.settings().set(TripType.LIMIT, 2.0);
    });
    cell(812, 0, c -> {
      gone(c);
      c.input(TripType.ODOMETRY).state(new InputState.Stale(4.2, "silent"));
    });
    cell(0, 306, c -> {});
    cell(406, 306, c -> c.input(TripType.ODOMETRY).state(new InputState.Waiting("base.odom: nothing came yet")));
    cell(812, 306, c -> c.input(TripType.ODOMETRY).state(new InputState.Failed("the robot sends what is no odometry")));
  }

  private static void gone(FakeUicContext context) {
    for (int i = 0; i < 50; i++) {
      TripPoses.at(context, "odom", 0.1 * i, 0);
      TripPoses.at(context, "wheel_encoders/odometry_with_a_long_name", 0.03 * i, 0);
    }
  }

  private void cell(int x, int y, Consumer<FakeUicContext> prepare) {
    FakeUicContext context = new FakeUicContext("trip", new TripType().schema());
    prepare.accept(context);
    Composite part = window.cell(x, y, 400, 300);
    TripUic uic = new TripUic(context);
    uic.tick(System.nanoTime());
    uic.createControl(part, UiContext.of(theme, part::setData));
    part.layout(true, true);
  }
}
