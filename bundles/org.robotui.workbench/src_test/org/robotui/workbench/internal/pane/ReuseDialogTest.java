package org.robotui.workbench.internal.pane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.host.ReuseReport;
import org.robotui.api.host.ReuseReport.Kind;
import org.robotui.api.host.ReuseReport.Row;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class ReuseDialogTest {
  private static final ReuseReport REPORT = new ReuseReport(List.of("Natalie", "Keira"), List.of(
      new Row(Kind.RFIC, "org.robotui.rfic.ros", "ROS 1", List.of("Natalie")),
      new Row(Kind.UIC, "org.robotui.uic.map", "Map", List.of("Natalie", "Keira"))));

  @TempDir
  Path folder;

  private Shell parent;
  private Theme theme;

  @BeforeEach
  void open() {
    parent = new Shell(TestDisplay.get());
    parent.setBounds(0, 0, 1200, 900);
    theme = Themes.of(TestDisplay.get(), Themes.LIGHT);
  }

  @AfterEach
  void close() {
    parent.dispose();
    theme.dispose();
  }

  @Test
  void savesAsTheFileIsNamed() throws Exception {
    ReuseDialog dialog = new ReuseDialog(parent, theme, REPORT);
    dialog.open();
    dialog.save(folder.resolve("a.csv"));
    dialog.save(folder.resolve("a.md"));
    assertEquals(REPORT.csv(), Files.readString(folder.resolve("a.csv")));
    assertEquals(REPORT.markdown(), Files.readString(folder.resolve("a.md")));
    assertTrue(Files.readString(folder.resolve("a.md")).contains("| Natalie | Keira | 1 | 1 | 0 |"));
  }

  @Test
  void withoutRobotsItSaysSo() {
    ReuseDialog dialog = new ReuseDialog(parent, theme, ReuseReport.EMPTY);
    dialog.open();
    assertTrue(dialog.shell().isVisible());
  }
}
