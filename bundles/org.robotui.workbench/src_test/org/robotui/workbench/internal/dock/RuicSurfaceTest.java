package org.robotui.workbench.internal.dock;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.api.layout.DropTarget;
import org.robotui.api.layout.Edge;
import org.robotui.api.layout.Layout;
import org.robotui.api.layout.WindowBounds;
import org.robotui.testkit.Controls;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewItem;
import org.robotui.ui.control.QuietButton;
import org.robotui.workbench.internal.pane.MessagePane;

@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class RuicSurfaceTest extends SurfaceBench {
  @Test
  void withoutAViewTheWindowSaysWhatCanBeDone() {
    RuicSurface surface = show(new Layout.View("map"));
    surface.docking().close("map");

    Controls.all(find(surface, MessagePane.class), QuietButton.class).getFirst().press();
    assertEquals(List.of("add"), asked);
    surface.docking().add("camera", Optional.empty());
    assertEquals(List.of("camera"), now().views());
    surface.docking().reset();
    assertTrue(map.control.isVisible());
  }

  @Test
  void aSecondViewOfATypeLiesBehindTheFirst() {
    RuicSurface surface = show(ROW);

    assertEquals("camera-2", surface.docking().add("camera", Optional.of("camera")));

    assertEquals(List.of("map", "plot", "camera", "camera-2"), now().views());
    surface.docking().close("camera-2");
    assertEquals(List.of(), now().added());
  }

  @Test
  void whereAWindowOfItsOwnIsPutIsKept() {
    RuicSurface surface = show(ROW);
    surface.docking().move("camera", new DropTarget.OwnWindow(new WindowBounds(50, 60, 300, 200)));
    Shell own = camera.control.getShell();
    TestDisplay.until(own::isVisible);
    own.setBounds(120, 80, 320, 240);

    TestDisplay.until(() -> now().windows().getFirst().bounds().equals(new WindowBounds(120, 80, 320, 240)));
    surface.docking().undo();
    assertEquals(ROW, now().layout(), "a window that was moved is no step of its own");
  }

  @Test
  void viewsThatAreMovedKeepTheKeys() {
    RuicSurface surface = show(ROW);
    TestDisplay.until(() -> camera.control.forceFocus() && camera.control.isFocusControl());

    surface.docking().move("camera", new DropTarget.Side("map", Edge.TOP));

    TestDisplay.until(() -> camera.control.isFocusControl());
  }

  @Test
  void aSplitSharesTheRoomAsTheLayoutSays() {
    show(new Layout.Split(Layout.Direction.ROW, List.of(new Layout.View("map"), new Layout.View("camera")),
        List.of(3.0, 1.0)));

    assertEquals(3.0, (double) map.control.getSize().x / camera.control.getSize().x, 0.1);
    assertEquals(map.control.getSize().y, camera.control.getSize().y);
  }

  @Test
  void aTabGetsItsControlWhenItIsSeen() {
    RuicSurface surface = show(new Layout.Tabs(List.of("map", "camera")));
    assertEquals(0, camera.created);

    find(surface, ViewStack.class).choose(1);

    assertEquals(1, camera.created);
    assertEquals("30 Hz", find(surface, TitleLine.class).note());
  }

  @Test
  void theTitleStandsAlsoWhereItsActionsTakeAllTheRoom() {
    TitleLine line = new TitleLine(shell, theme, List.of("Joints"), new NoGestures());
    line.setSize(220, TitleLine.HEIGHT);
    line.actions(List.of(new ViewAction("degrees", "Angles in degrees", "", Optional.of(() -> true), () -> {}),
        new ViewAction("yaml", "Copy as YAML", "copy", Optional.empty(), () -> {})));

    List<QuietButton> seen = Controls.all(line, QuietButton.class).stream().filter(QuietButton::getVisible).toList();
    assertEquals(2, seen.size(), "one action, and the button for what there is no room for");
    assertTrue(seen.stream().allMatch(button -> button.getLocation().x >= 60), "none over the title");
  }

  @Test
  void whatAViewListsIsFoundAndBringsTheViewToTheFront() {
    RuicSurface surface = show(new Layout.Tabs(List.of("map", "camera")));
    assertEquals(List.of("first of follow"), surface.items().stream().map(ViewItem::name).toList(),
        "of views seen so far");
    find(surface, ViewStack.class).choose(1);

    surface.items().getFirst().show().run();

    assertEquals(1, map.shownItems);
    assertTrue(map.control.isVisible());
  }

  @Test
  void framesOfATabThatIsNotSeenAreNotPainted() {
    RuicSurface surface = show(new Layout.Tabs(List.of("map", "camera")));
    find(surface, ViewStack.class).choose(1);
    int before = map.refreshed;

    surface.refresh("map");

    assertEquals(before, map.refreshed);
  }

  @Test
  void theTitleOfTheViewThatHasTheKeysIsMarked() {
    RuicSurface surface = show(new Layout.Split(Layout.Direction.ROW,
        List.of(new Layout.View("map"), new Layout.View("camera")), List.of(1.0, 1.0)));
    List<TitleLine> lines = Controls.all(surface, TitleLine.class);
    shell.open();
    TestDisplay.until(() -> camera.control.forceFocus() && camera.control.isFocusControl());

    TestDisplay.until(() -> !lines.getFirst().isFocused() && lines.getLast().isFocused());
    surface.reveal("map");

    TestDisplay.until(() -> lines.getFirst().isFocused() && !lines.getLast().isFocused());
    assertEquals(Optional.of("map"), surface.focused().map(ViewEntry::id));
    Text elsewhere = new Text(shell, SWT.NONE);
    TestDisplay.until(() -> elsewhere.forceFocus() && elsewhere.isFocusControl());

    assertEquals(Optional.empty(), surface.focused());
    assertEquals(Optional.of("map"), surface.lastFocused().map(ViewEntry::id),
        "whose page the menu Help has");
  }

  @Test
  void viewsAreListedWithWhatIsSeenAndWhatDoesNotWork() {
    ruic.surfaceFailed("camera", "it threw");
    RuicSurface surface = show(new Layout.Tabs(List.of("map", "camera")));

    assertEquals(List.of("map true", "camera (does not work) false"),
        surface.views().stream().map(view -> view.label() + " " + view.seen()).toList());

    surface.reveal("camera");

    assertEquals(List.of(false, true), surface.views().stream().map(ViewEntry::seen).toList());
  }

  @Test
  void aFailureOnTheDisplayThreadIsBlamedOnTheViewWhoseCodeTookPart() {
    RuicSurface surface = show(new Layout.View("map"));

    assertFalse(surface.blame(foreign()));
    assertTrue(surface.blame(new IllegalStateException("thrown in this package")));

    assertEquals(List.of(), ruic.calls(), "not within the paint that failed");
    while (surface.getDisplay().readAndDispatch()) {
      // what was put off is done now
    }
    assertEquals(List.of("surfaceFailed map"), ruic.calls());
  }

  private static Throwable foreign() {
    Throwable failure = new IllegalStateException("elsewhere");
    failure
        .setStackTrace(new StackTraceElement[]{new StackTraceElement("org.example.Other", "paint", "Other.java", 1)});
    return failure;
  }
}
