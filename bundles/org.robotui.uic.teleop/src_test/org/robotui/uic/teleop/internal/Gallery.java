package org.robotui.uic.teleop.internal;

import java.util.function.Consumer;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.port.InputState;
import org.robotui.data.command.VelocityCommand;
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
    cell(0, 0, 500, 290, c -> {});
    cell(506, 0, 500, 290, c -> c.input(TeleopType.ODOM).put(VelocityCommand.planar(0.21, -0.16)), d -> {
      d.drag(new Stick(0.6, -0.2), 0);
      for (long i = 0; i < 30; i++) {
        d.tick(i * 50_000_000);
      }
    });
    cell(1012, 0, 580, 290, c -> c.authority().take(FakeAuthority.ANNA, false), Driver::take);
    cell(0, 296, 500, 290, c -> c.authority().stop(FakeAuthority.YOU));
    cell(506, 296, 500, 290, c -> c.output(TeleopType.CMD_VEL).state(new InputState.Unconnected(
        "Keira offers no VelocityCommand. Connect a base that can be driven, for example /cmd_vel of ros.")));
    cell(1012, 296, 580, 290, c -> c.output(TeleopType.CMD_VEL).state(new InputState.Stale(2.1, "the link is lost")));
    cell(0, 592, 260, 400, c -> c.authority().take(FakeAuthority.YOU, false));
    cell(266, 592, 180, 220, c -> {});
    cell(452, 592, 400, 180, c -> c.authority().take(FakeAuthority.ANNA, false));
    cell(452, 778, 250, 210, c -> c.authority().take(FakeAuthority.YOU, false),
        d -> {}, new InputState.Waiting("base./cmd_vel: no link (localhost:11311 refuses the connection, retry 4 s)"));
    cell(858, 592, 360, 290, c -> c.output(TeleopType.CMD_VEL).outcome(() -> new CommandOutcome.Refused(
        CommandOutcome.Why.LINK_DOWN, "the link to localhost:11311 is down, trying again")), d -> {
          d.press(DriveKey.FORWARD_LEFT, 0);
          d.tick(0);
        });
    cell(1224, 592, 360, 290, c -> c.output(TeleopType.CMD_VEL).state(new InputState.Failed(
        "/cmd_vel has the type geometry_msgs/TwistStamped, expected geometry_msgs/Twist")));
  }

  private void cell(int x, int y, int width, int height, Consumer<FakeUicContext> prepare) {
    cell(x, y, width, height, prepare, driver -> {});
  }

  private void cell(int x, int y, int width, int height, Consumer<FakeUicContext> prepare, Consumer<Driver> drive) {
    cell(x, y, width, height, prepare, drive, new InputState.Live(0, 0));
  }

  private void cell(int x, int y, int width, int height, Consumer<FakeUicContext> prepare, Consumer<Driver> drive,
      InputState output) {
    FakeUicContext context = new FakeUicContext("teleop", new TeleopType().schema());
    context.output(TeleopType.CMD_VEL).state(output);
    prepare.accept(context);
    Driver driver = new Driver(context.output(TeleopType.CMD_VEL), context.input(TeleopType.ODOM),
        context.input(TeleopType.NAVIGATION), context.principal(),
        context.settings());
    drive.accept(driver);
    Composite part = window.cell(x, y, width, height);
    new TeleopUic(driver, context.settings(), context.background()).createControl(part,
        UiContext.of(theme, part::setData));
    part.layout();
  }
}
