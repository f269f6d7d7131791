package org.robotui.uic.map.internal;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Display;
import org.robotui.data.navigation.Odometry;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

/** Shows a live map in a window until it is closed, to try it by hand: {@code MapWindow dark|light}. */
final class MapWindow {
  private static final int TICK_MILLIS = 33;

  private final Display display;
  private final MapStage stage;
  private final List<Odometry> way = DemoRoom.drive();
  private int at;

  private MapWindow(Display display, Theme theme) {
    this.display = display;
    this.stage = new MapStage(display, theme, 1100, 700);
  }

  public static void main(String[] arguments) {
    Display display = new Display();
    MapWindow window = new MapWindow(display, Themes.of(display, arguments[0]));
    window.show();
  }

  private void show() {
    DemoRoom.fill(stage.context, System.nanoTime());
    stage.replace();
    stage.open();
    step();
    while (!stage.shell.isDisposed()) {
      if (!display.readAndDispatch()) {
        display.sleep();
      }
    }
  }

  private void step() {
    if (!stage.shell.isDisposed()) {
      stage.context.input(MapPorts.ODOM)
          .put(DemoRoom.source("odom"), way.get(Math.min(at++, way.size() - 1)), System.nanoTime(), Optional.empty());
      stage.context.input(MapPorts.SCAN)
          .put(DemoRoom.source("scan"), DemoRoom.scan(), System.nanoTime(), Optional.empty());
      stage.uic.tick(System.nanoTime());
      stage.uic.refresh();
      display.timerExec(TICK_MILLIS, this::step);
    }
  }
}
