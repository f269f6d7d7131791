package org.robotui.uic.status.internal;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.Battery;
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
    cell(566, 506, 560, 240, c -> { });
    cell(1132, 506, 460, 240, c -> c.ruic().snapshot(Snapshots.of(new LinkState.Connecting("localhost:11311"), List.of(), List.of())));
  }

  private static void typical(FakeUicContext context) {
    context.ruic().snapshot(Snapshots.typical());
    battery(context, "/battery", 0.87);
    battery(context, "/arm/battery", 0.18);
    context.input(StatusType.BATTERY).state(new SourceId("base", "/gripper/battery"), new InputState.Waiting("nothing came yet"));
  }

  private static void battery(FakeUicContext context, String port, double charge) {
    context.input(StatusType.BATTERY).put(new SourceId("base", port),
        new Battery(14.1, -1.2, charge, Battery.Status.DISCHARGING), System.nanoTime(), Optional.empty());
  }

  private void cell(int x, int y, int width, int height, Consumer<FakeUicContext> prepare) {
    FakeUicContext context = new FakeUicContext("status", new StatusType().schema());
    prepare.accept(context);
    Composite part = new Composite(shell, SWT.NONE);
    part.setBounds(x, y, width, height);
    part.setLayout(new FillLayout());
    StatusUic uic = new StatusUic(context);
    uic.tick(System.nanoTime());
    uic.createControl(part, new UiContext() {
      @Override
      public Theme theme() {
        return theme;
      }

      @Override
      public void note(String text) {
        part.setData(text);
      }
    });
    part.layout(true, true);
  }
}
