package org.robotui.workbench.internal.pane;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.Arrays;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Health;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.workbench.internal.model.PortRow;
import org.robotui.workbench.internal.model.RobotRow;

/** Lists as narrow as in a small window. */
@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class RowListTest {
  private static final int NARROW = 157;
  private static final int HEIGHT = 48;

  private Theme theme;
  private Shell shell;

  @BeforeEach
  void open() {
    theme = Themes.dark(TestDisplay.get());
    shell = new Shell(TestDisplay.get(), SWT.NO_TRIM);
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void theRateGivesWayToTheNameOfAPort() {
    PortList list = new PortList(shell, theme);
    assertArrayEquals(port(list, "battery_state", ""), port(list, "battery_state", "1.0 Hz"));
    assertFalse(Arrays.equals(port(list, "fix", ""), port(list, "fix", "1.0 Hz")), "there is room for both");
  }

  @Test
  void theFigureGivesWayToTheNameOfARobot() {
    RobotList list = new RobotList(shell, theme, name -> {});
    assertArrayEquals(robot(list, "Natalie (ROS)", ""), robot(list, "Natalie (ROS)", "connecting"));
    assertFalse(Arrays.equals(robot(list, "r1", ""), robot(list, "r1", "connecting")), "there is room for both");
  }

  private byte[] port(PortList list, String name, String figure) {
    return row(list, new PortRow(name, Health.OK, figure, "", "", Optional.empty()));
  }

  private byte[] robot(RobotList list, String name, String figure) {
    return row(list, new RobotRow(name, Health.OK, figure, "ros"));
  }

  /** The picture of a row. */
  private static <R> byte[] row(RowList<R> list, R row) {
    Image image = new Image(list.getDisplay(), NARROW, HEIGHT);
    GC gc = new GC(image);
    list.prepare(gc, NARROW);
    list.paintRow(gc, row, 0, NARROW);
    gc.dispose();
    byte[] data = image.getImageData().data;
    image.dispose();
    return data;
  }
}
