package org.robotui.ui.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.record.DynamicRecord;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class RecordTreeSwtTest {
  private static final int ROW = 24;

  private final Display display = TestDisplay.get();
  private Theme theme;
  private Shell shell;
  private RecordTree tree;

  @BeforeEach
  void open() {
    theme = Themes.light(display);
    shell = new Shell(display);
    shell.setLayout(new FillLayout());
    tree = new RecordTree(shell, theme);
    shell.setSize(400, 500);
    shell.layout();
    tree.show(Records.scan(360, 0));
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void aPressOnTheSignOpensAndClosesWithoutSelecting() {
    press(10, 0);
    assertEquals("header", path(0));
    assertEquals("angle_min", path(1));
    press(10, 0);
    assertEquals("header.seq", path(1));
    assertEquals(Optional.empty(), tree.selected());
  }

  @Test
  void aQuickSecondPressOnTheSignIsNoDoubleClick() {
    press(10, 0);
    press(10, 0);
    Event event = new Event();
    event.button = 1;
    event.x = 10;
    event.y = 5;
    tree.control().notifyListeners(SWT.MouseDoubleClick, event);
    assertEquals("header.seq", path(1));
  }

  @Test
  void arrowsOpenCloseAndGoToTheParent() {
    press(60, 2);
    assertEquals(Optional.of("header.stamp"), tree.selected());
    key(SWT.ARROW_LEFT);
    assertEquals(Optional.of("header"), tree.selected());
    key(SWT.ARROW_LEFT);
    assertEquals("angle_min", path(1));
    key(SWT.ARROW_RIGHT);
    assertEquals("header.seq", path(1));
  }

  @Test
  void theSelectionStaysOverUpdates() {
    press(60, 2);
    for (int i = 0; i < 30; i++) {
      tree.show(Records.scan(360 + i, i));
    }
    assertEquals(Optional.of("header.stamp"), tree.selected());
  }

  @Test
  void enterOpensRecordsAndTellsOfPlainFields() {
    List<String> opened = new ArrayList<>();
    tree.onOpen(opened::add);
    press(60, 0);
    key(SWT.CR);
    assertEquals("angle_min", path(1));
    press(60, 1);
    key(SWT.CR);
    assertEquals(List.of("angle_min"), opened);
  }

  @Test
  void aLargeRecordIsUpdatedQuickly() {
    tree.show(Records.scan(100_000, 0));
    List<DynamicRecord> records = new ArrayList<>();
    for (int i = 0; i < 30; i++) {
      records.add(Records.scan(100_000, i));
    }
    long start = System.nanoTime();
    records.forEach(tree::show);
    double millis = (System.nanoTime() - start) / 1e6;
    assertTrue(millis < 1000, "30 updates took " + millis + " ms");
  }

  private String path(int row) {
    return tree.list().rows().get(row).path();
  }

  private void press(int x, int row) {
    Event event = new Event();
    event.button = 1;
    event.x = x;
    event.y = row * ROW + 5;
    tree.control().notifyListeners(SWT.MouseDown, event);
    tree.control().notifyListeners(SWT.MouseUp, event);
  }

  private void key(int keyCode) {
    Event event = new Event();
    event.keyCode = keyCode;
    tree.control().notifyListeners(SWT.KeyDown, event);
  }
}
