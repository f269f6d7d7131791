package org.robotui.workbench.internal.pane;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.robotui.api.command.Principal;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.Problem;
import org.robotui.api.host.RuicState;
import org.robotui.api.layout.Layout;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.testkit.host.FakeRuic;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.workbench.internal.display.Screenshot;
import org.robotui.workbench.internal.dock.ArrangeHistory;
import org.robotui.workbench.internal.dock.PaintedView;
import org.robotui.workbench.internal.dock.RobotArea;
import org.robotui.workbench.internal.model.Lease;
import org.robotui.workbench.internal.model.PortRow;
import org.robotui.workbench.internal.model.RobotRow;
import org.robotui.workbench.internal.model.StatusText;
import org.robotui.workbench.internal.model.Stops;

/** A window of all panes with invented robots, to look at without a workbench: {@code Gallery dark|light FILE}. */
final class Gallery {
  private static final Principal YOU = new Principal("w", "You", Principal.Kind.WINDOW);

  private Gallery() {}

  public static void main(String[] words) throws IOException {
    Display display = new Display();
    Theme theme = Themes.of(display, words[0]);
    Shell shell = new Shell(display, SWT.NO_TRIM);
    fill(shell, theme, words.length > 2);
    shell.setBounds(0, 0, 1600, 980);
    shell.open();
    long end = System.nanoTime() + Duration.ofMillis(1500).toNanos();
    while (System.nanoTime() < end) {
      if (!display.readAndDispatch()) {
        Thread.onSpinWait();
      }
    }
    Screenshot.save(shell, Path.of(words[1]));
    shell.dispose();
    theme.dispose();
    display.dispose();
  }

  private static void fill(Shell shell, Theme theme, boolean problems) {
    GridLayout layout = new GridLayout(2, false);
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    layout.horizontalSpacing = 1;
    layout.verticalSpacing = 0;
    shell.setLayout(layout);
    TopBar bar = place(new TopBar(shell, theme, Menus.ALL, new NoActions()), SWT.FILL, SWT.TOP, 2);
    Navigator navigator = place(new Navigator(shell, theme, new NoActions()), SWT.BEGINNING, SWT.FILL, 1);
    ((GridData) navigator.getLayoutData()).widthHint = 220;
    RobotArea area =
        place(new RobotArea(shell, theme, r -> new ArrangeHistory(), new NoActions()), SWT.FILL, SWT.FILL, 1);
    StatusBar status = place(new StatusBar(shell, theme, () -> {}), SWT.FILL, SWT.BOTTOM, 2);
    FakeRuic keira = keira();
    keira.authority().take(YOU, false);
    bar.show(Lease.of(keira.authorities(), keira.snapshot().link(), YOU),
        new Stops(List.of("Keira", "Natalie"), problems ? List.of("Natalie") : List.of()));
    navigator.show(Stream.of(keira, husky(), natalie()).map(FakeRuic::snapshot).map(RobotRow::of).toList(),
        Optional.of("Keira"), PortRow.of(keira.snapshot()));
    area.show(Optional.of(keira));
    if (problems) {
      area.problems(List.of(
          new Problem("configs/keira.yaml", 12, 7, Problem.Severity.ERROR,
              "there is no setting 'topcis' for the type ros; did you mean 'topics'?"),
          new Problem("configs/keira.yaml", 20, 3, Problem.Severity.WARNING,
              "the view 'plot' has no place in the layout")));
    }
    status.show(StatusText.of(keira.snapshot(), keira.clock()));
    status.alert(problems ? "camera: the view was fenced after 2 s" : "");
  }

  private static <C extends Control> C place(C control, int horizontal, int vertical, int columns) {
    control.setLayoutData(new GridData(horizontal, vertical, horizontal == SWT.FILL, vertical == SWT.FILL, columns, 1));
    return control;
  }

  static FakeRuic keira() {
    Layout column = new Layout.Split(Layout.Direction.COLUMN,
        List.of(new Layout.View("camera"), new Layout.View("teleop"), new Layout.Tabs(List.of("status", "plot"))),
        List.of(3.0, 3.0, 4.0));
    Layout layout =
        new Layout.Split(Layout.Direction.ROW, List.of(new Layout.View("map"), column), List.of(64.0, 36.0));
    FakeRuic keira = new FakeRuic("Keira").laidOut(layout).linked(new LinkState.Connected("http://localhost:11411/"))
        .titled("map", "Map").titled("camera", "Camera").titled("teleop", "Teleop").titled("status", "Status")
        .titled("plot", "Plot")
        .component(new ComponentStatus("base", "ros", ComponentStatus.Kind.RFIC, RuicState.INITIALIZED, "",
            Optional.empty()))
        .view("map", new PaintedView("follow \u00b7 odom \u00b7 0.05 m/px"))
        .view("teleop", new PaintedView("lease: you \u00b7 max 0.40 m/s"))
        .view("status", new PaintedView("link up 14 min"))
        .view("plot", new PaintedView(""))
        .offering(port("scan", 10.0, 0.012, false, 100), port("odometry", 50.1, 0.004, false, 500),
            port("bumper", 0, 3, false, 2), port("power", 1.0, 0.8, false, 9), port("imu", 40, 2.1, true, 5),
            port("/front/image_raw", 0, Double.NaN, false, 0))
        .in(RuicState.SELECTED, "");
    keira.fail("camera", "The bundle org.robotui.uic.camera is not installed.");
    return keira;
  }

  private static FakeRuic husky() {
    return new FakeRuic("Husky 2")
        .linked(new LinkState.Failed("10.0.0.7:11311 refused the connection", Duration.ofSeconds(4)))
        .component(new ComponentStatus("base", "ros", ComponentStatus.Kind.RFIC, RuicState.INITIALIZED, "",
            Optional.empty()));
  }

  private static FakeRuic natalie() {
    return new FakeRuic("Natalie").linked(new LinkState.Connected("http://natalie:11311/"))
        .offering(port("scan", 38, 0.01, false, 9))
        .component(new ComponentStatus("base", "ros", ComponentStatus.Kind.RFIC, RuicState.INITIALIZED, "",
            Optional.empty()));
  }

  private static PortStatus port(String name, double rate, double age, boolean stale, long count) {
    return new PortStatus(new SourceId("base", name), PortKind.STREAM, "LaserScan", true, count, rate, age, stale, 0,
        "",
        "");
  }
}
