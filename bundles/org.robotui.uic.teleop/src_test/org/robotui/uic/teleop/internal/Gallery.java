package org.robotui.uic.teleop.internal;

import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.robotui.api.command.CommandOutcome;
import org.robotui.api.port.InputState;
import org.robotui.data.VelocityCommand;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;

/** Shows the view in all its states side by side, for a person to look at: {@code Gallery dark|light}. */
final class Gallery {
  private final Shell shell;
  private final Theme theme;

  private Gallery(Shell shell, Theme theme) {
    this.shell = shell;
    this.theme = theme;
  }

  public static void main(String[] arguments) {
    Display display = new Display();
    Theme theme = Themes.of(display, arguments[0]);
    Shell shell = new Shell(display, SWT.NO_TRIM);
    shell.setBounds(0, 0, 1600, 1000);
    shell.setBackground(theme.color(Role.LINE));
    new Gallery(shell, theme).fill();
    shell.open();
    while (!shell.isDisposed()) {
      if (!display.readAndDispatch()) {
        display.sleep();
      }
    }
  }

  private void fill() {
    cell(0, 0, 500, 290, c -> { });
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
    cell(266, 592, 180, 220, c -> { });
    cell(452, 592, 400, 180, c -> c.authority().take(FakeAuthority.ANNA, false));
    cell(858, 592, 360, 290, c -> c.output(TeleopType.CMD_VEL).outcome(() -> new CommandOutcome.Refused(
        CommandOutcome.Why.LINK_DOWN, "the link to localhost:11311 is down, trying again")), d -> {
      d.press(DriveKey.FORWARD_LEFT, 0);
      d.tick(0);
    });
    cell(1224, 592, 360, 290, c -> c.output(TeleopType.CMD_VEL).state(new InputState.Failed(
        "/cmd_vel has the type geometry_msgs/TwistStamped, expected geometry_msgs/Twist")));
  }

  private void cell(int x, int y, int width, int height, Consumer<FakeUicContext> prepare) {
    cell(x, y, width, height, prepare, driver -> { });
  }

  private void cell(int x, int y, int width, int height, Consumer<FakeUicContext> prepare, Consumer<Driver> drive) {
    FakeUicContext context = new FakeUicContext("teleop", new TeleopType().schema());
    prepare.accept(context);
    Driver driver = new Driver(context.output(TeleopType.CMD_VEL), context.input(TeleopType.ODOM), context.principal(),
        context.settings());
    drive.accept(driver);
    Composite part = new Composite(shell, SWT.NONE);
    part.setBounds(x, y, width, height);
    part.setLayout(new FillLayout());
    new TeleopUic(driver, context.settings()).createControl(part, new UiContext() {
      @Override
      public Theme theme() {
        return theme;
      }

      @Override
      public void note(String text) {
        part.setData(text);
      }
    });
    part.layout();
  }
}
