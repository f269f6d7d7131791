package org.robotui.workbench.internal.dock;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Sash;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.api.layout.Layout;
import org.robotui.testkit.Controls;
import org.robotui.testkit.TestDisplay;

@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class DragViewsTest extends SurfaceBench {
  /** Presses a title, moves the pointer to a place of another control, and lets go. */
  private void drag(String view, Control to, int x, int y) {
    TitleLine from = line(view);
    Point target = from.toControl(to.toDisplay(x, y));
    send(from, SWT.MouseDown, 20, 10, 0, 1);
    send(from, SWT.MouseMove, (20 + target.x) / 2, (10 + target.y) / 2, SWT.BUTTON1, 0);
    send(from, SWT.MouseMove, target.x, target.y, SWT.BUTTON1, 0);
    send(from, SWT.MouseUp, target.x, target.y, SWT.BUTTON1, 1);
    shell.layout(true, true);
  }

  @Test
  void aViewIsDraggedBesideAnotherAndGoesOnAsItWas() {
    show(ROW);
    Control painted = map.control;

    drag("map", camera.control, camera.control.getSize().x / 2, camera.control.getSize().y - 20);

    assertEquals(List.of("plot", "camera", "map"), now().views());
    assertTrue(((Layout.Split) now().layout()).parts().getLast() instanceof Layout.Split column
        && column.direction() == Layout.Direction.COLUMN);
    assertEquals(1, map.created, "the control is the same");
    assertFalse(painted.isDisposed());
    assertTrue(painted.isVisible());
    assertTrue(painted.toDisplay(0, 0).y > camera.control.toDisplay(0, 0).y);
    assertEquals(1, plot.created, "what was behind it is seen");
  }

  @Test
  void aViewIsDraggedAmongTheTabsOfAnother() {
    RuicSurface surface = show(ROW);

    drag("camera", map.control, map.control.getSize().x / 2, map.control.getSize().y / 2);

    assertEquals(new Layout.Tabs(List.of("map", "plot", "camera"), 2), now().layout());
    assertTrue(camera.control.isVisible());
    surface.docking().undo();
    assertEquals(ROW, now().layout());
    surface.docking().redo();
    assertEquals(List.of("map", "plot", "camera"), now().layout().views());
  }

  @Test
  void aTabIsDraggedBeforeAnother() {
    show(new Layout.Tabs(List.of("map", "plot", "camera")));
    TitleLine line = line("map");

    drag("map", line, line.getSize().x - 200, 10);

    assertEquals(List.of("plot", "camera", "map"), now().layout().views());
  }

  @Test
  void aViewIsDraggedAlongAWholeSide() {
    RuicSurface surface = show(ROW);

    drag("plot", surface, 400, surface.getSize().y - 4);

    assertEquals(Layout.Direction.COLUMN, ((Layout.Split) now().layout()).direction());
    assertTrue(Controls.all(surface, Aside.class).stream().noneMatch(Control::getVisible), "the frame is gone");
  }

  @Test
  void whatIsDroppedBesideTheWindowsHasAWindowOfItsOwnThatIsClosedWithTheView() {
    RuicSurface surface = show(ROW);

    drag("camera", surface, 900, 300);

    assertEquals(1, now().windows().size());
    assertEquals(1, camera.created);
    Shell own = camera.control.getShell();
    assertTrue(own != shell && own.isVisible());
    assertEquals("camera - Keira", own.getText());
    surface.refresh("camera");
    own.close();
    assertTrue(camera.control.isDisposed());
    assertEquals(List.of("map", "plot"), now().views());
    surface.docking().undo();
    assertEquals(2, camera.created);
    surface.dispose();
    assertTrue(camera.control.isDisposed(), "its window goes with the robot");
    assertEquals(1, now().windows().size());
  }

  @Test
  void escapeEndsADrag() {
    show(ROW);
    TitleLine from = line("map");
    Point target = from.toControl(camera.control.toDisplay(50, 50));
    send(from, SWT.MouseDown, 20, 10, 0, 1);
    send(from, SWT.MouseMove, target.x, target.y, SWT.BUTTON1, 0);
    Event escape = new Event();
    escape.keyCode = SWT.ESC;
    from.notifyListeners(SWT.KeyDown, escape);
    TestDisplay.get().post(escape);
    Event key = new Event();
    key.type = SWT.KeyDown;
    key.keyCode = SWT.ESC;
    shell.notifyListeners(SWT.KeyDown, key);
    send(from, SWT.MouseUp, target.x, target.y, SWT.BUTTON1, 1);

    assertEquals(ROW, now().layout());
  }

  @Test
  void aPressThatHardlyMovesIsNoDrag() {
    show(ROW);
    TitleLine from = line("map");
    send(from, SWT.MouseDown, 20, 10, 0, 1);
    send(from, SWT.MouseMove, 23, 12, SWT.BUTTON1, 0);
    send(from, SWT.MouseUp, 23, 12, SWT.BUTTON1, 1);

    assertEquals(ROW, now().layout());
  }

  @Test
  void aDoubleClickHasAViewTakeTheWholeWindow() {
    RuicSurface surface = show(ROW);
    send(line("camera"), SWT.MouseDoubleClick, 20, 10, 0, 1);
    shell.layout(true, true);

    assertEquals(800, camera.control.getSize().x);
    assertEquals(0, stack(map).getSize().x);
    surface.reveal("map");
    assertTrue(stack(map).getSize().x > 0, "whoever looks for another view sees it");
    TestDisplay.until(() -> map.control.forceFocus() && map.control.isFocusControl());
    surface.maximize();
    assertEquals(0, stack(camera).getSize().x);
  }

  @Test
  void theMiddleButtonClosesAView() {
    RuicSurface surface = show(ROW);
    send(line("camera"), SWT.MouseDown, 20, 10, 0, 2);

    assertEquals(List.of("map", "plot"), now().views());
    assertTrue(camera.control.isDisposed());
    surface.docking().open("camera");
    assertEquals(List.of("map", "plot", "camera"), now().views());
  }

  @Test
  void whatIsLockedStaysWhereItLies() {
    RuicSurface surface = show(ROW);
    TestDisplay.until(() -> !TestDisplay.get().readAndDispatch());
    surface.lock(true);

    drag("map", camera.control, 50, 50);
    send(line("camera"), SWT.MouseDown, 20, 10, 0, 2);
    surface.docking().reset();

    assertEquals(ROW, now().layout());
    assertTrue(Controls.all(shell, Sash.class).stream().noneMatch(Sash::getEnabled));
    ruic.arranging().keep("All");
    surface.docking().choose("All");
    surface.lock(false);
    send(line("camera"), SWT.MouseDown, 20, 10, 0, 2);
    assertEquals(List.of("map", "plot"), now().views());
  }

  @Test
  void howTheUserDividesASplitIsKept() {
    show(ROW);
    TestDisplay.until(() -> !TestDisplay.get().readAndDispatch());
    Sash sash = Controls.all(shell, Sash.class).getFirst();
    Event moved = new Event();
    moved.x = 600;
    moved.width = sash.getSize().x;
    moved.height = sash.getSize().y;
    sash.notifyListeners(SWT.Selection, moved);

    TestDisplay.until(() -> ((Layout.Split) now().layout()).weights().getFirst() > 600);
    assertTrue(map.control.getSize().x > 2 * camera.control.getSize().x);
  }

  @Test
  void theFrontTabIsKeptAndIsNoStepOfItsOwn() {
    RuicSurface surface = show(ROW);
    send(line("plot"), SWT.KeyDown, 0, 0, 0, 0);
    Event right = new Event();
    right.keyCode = SWT.ARROW_RIGHT;
    line("plot").notifyListeners(SWT.KeyDown, right);

    assertEquals(new Layout.Tabs(List.of("map", "plot"), 1), ((Layout.Split) now().layout()).parts().getFirst());
    assertFalse(surface.docking().canUndo());
    assertTrue(plot.control.isVisible());
  }
}
