package org.robotui.uic.jointcontrol.internal;

import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Display;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.joint.JointControl;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.GalleryWindow;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;

/** Shows the view in its states side by side, for a person to look at: {@code Gallery dark|light [page]}. */
final class Gallery {
  private static final long MS = 1_000_000;

  private final GalleryWindow window;
  private final Theme theme;

  private Gallery(GalleryWindow window, Theme theme) {
    this.window = window;
    this.theme = theme;
  }

  public static void main(String[] arguments) {
    Display display = new Display();
    Theme theme = Themes.of(display, arguments[0]);
    GalleryWindow window = new GalleryWindow(display, theme.color(Role.LINE));
    Gallery gallery = new Gallery(window, theme);
    switch (arguments.length > 1 ? arguments[1] : "1") {
      case "1" -> gallery.first();
      case "2" -> gallery.second();
      default -> gallery.third();
    }
    window.show();
  }

  private void first() {
    cell(0, 0, 1600, 420, "arm/arm_2", (c, u) -> Robots.put(c, Robots.armModel(), Robots.arm()));
    cell(0, 426, 1000, 380, "arm/arm_4", (c, u) -> Robots.put(c, Robots.armModel(), Robots.troubled()));
    cell(1006, 426, 594, 380, "arm/arm_5", this::driving);
    cell(0, 812, 500, 188, "", (c, u) -> {
      Robots.put(c, Robots.armModel(), Robots.arm());
      c.input(JointControlPorts.CONTROL).state(new InputState.Stale(4.2, "silent"));
    });
    cell(506, 812, 360, 188, "", (c, u) -> {});
    cell(872, 812, 360, 188, "",
        (c, u) -> c.input(JointControlPorts.CONTROL).state(new InputState.Waiting("base.control: nothing came yet")));
    cell(1238, 812, 362, 188, "", (c, u) -> c.input(JointControlPorts.CONTROL).put(new SourceId("base", "control"),
        new JointControl(List.of()), 0, Optional.empty()));
  }

  private void second() {
    cell(0, 0, 1280, 494, "left_arm/L3", (c, u) -> Robots.put(c, Robots.humanoidModel(), Robots.humanoid()));
    cell(0, 500, 900, 500, "arm/arm_2", this::driving);
    cell(906, 500, 694, 246, "", (c, u) -> {
      Robots.put(c, Robots.armModel(), Robots.arm(JointControl.Source.COMMANDED, "homing"));
      c.authority().take(FakeAuthority.ANNA, true);
      u.tick(0);
      u.driver().toggle();
    });
    cell(906, 752, 694, 248, "", (c, u) -> {
      driving(c, u);
      c.authority().stop(FakeAuthority.YOU);
    });
  }

  private void third() {
    cell(0, 0, 794, 496, "arm/arm_4", (c, u) -> {
      driving(c, u);
      u.driver().jog(true);
    });
    cell(800, 0, 800, 496, "", (c, u) -> {
      driving(c, u);
      c.input(JointControlPorts.CONTROL).state(new InputState.Stale(0.8, "silent"));
    });
    cell(0, 502, 340, 498, "arm/arm_4", (c, u) -> Robots.put(c, Robots.armModel(), Robots.troubled()));
    cell(346, 502, 448, 498, "arm/arm_2", (c, u) -> {
      c.settings().set(JointControlType.DEGREES, false);
      driving(c, u);
    });
    cell(800, 502, 394, 246, "", (c, u) -> {
      Robots.put(c, Robots.armModel(), Robots.arm());
      u.tick(0);
      u.driver().toggle();
    });
    cell(1200, 502, 400, 246, "", (c, u) -> {
      driving(c, u);
      u.driver().end("Not driving any more: the view lost the focus");
    });
    cell(800, 754, 394, 246, "", (c, u) -> c.input(JointControlPorts.CONTROL).put(new SourceId("base", "control"),
        Robots.arm(), 0, Optional.empty()));
    cell(1200, 754, 400, 246, "", (c, u) -> {
      Robots.put(c, Robots.armModel(), Robots.arm());
      c.output(JointControlPorts.COMMAND).state(new InputState.Unconnected("nothing there takes commands for joints"));
    });
  }

  private void driving(FakeUicContext context, JointControlUic uic) {
    Robots.put(context, Robots.armModel(), Robots.arm());
    uic.tick(0);
    uic.driver().toggle();
    uic.driver().confirm(true);
    uic.driver().goal("arm_2", 0.9);
    uic.driver().goal("arm_5", -1.2);
    uic.driver().goal("finger", 0.03);
    for (int i = 1; i < 8; i++) {
      uic.tick(i * 50 * MS);
    }
  }

  private void cell(int x, int y, int width, int height, String selected,
      BiConsumer<FakeUicContext, JointControlUic> prepare) {
    FakeUicContext context = new FakeUicContext("jointcontrol", new JointControlType().schema());
    Composite part = window.cell(x, y, width, height);
    JointControlUic uic = new JointControlUic(context);
    prepare.accept(context, uic);
    uic.tick(400 * MS);
    uic.createControl(part, UiContext.of(theme, part::setData));
    part.layout(true, true);
    uic.select(selected);
  }
}
