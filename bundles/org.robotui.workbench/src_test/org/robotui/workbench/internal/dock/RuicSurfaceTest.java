package org.robotui.workbench.internal.dock;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Sash;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfEnvironmentVariable;
import org.robotui.api.host.RuicState;
import org.robotui.api.layout.Arrangement;
import org.robotui.api.layout.DropTarget;
import org.robotui.api.layout.Edge;
import org.robotui.api.layout.Layout;
import org.robotui.api.layout.WindowBounds;
import org.robotui.testkit.Controls;
import org.robotui.testkit.TestDisplay;
import org.robotui.testkit.host.FakeRuic;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.ViewAction;
import org.robotui.ui.control.QuietButton;
import org.robotui.workbench.internal.pane.MessagePane;

@EnabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+")
class RuicSurfaceTest {
  private static final Layout ROW = new Layout.Split(Layout.Direction.ROW,
      List.of(new Layout.Tabs(List.of("map", "plot")), new Layout.View("camera")), List.of(1.0, 1.0));

  private final PaintedView map = new PaintedView("follow");
  private final PaintedView camera = new PaintedView("30 Hz");
  private final PaintedView plot = new PaintedView("");
  private final FakeRuic ruic = new FakeRuic("Keira").in(RuicState.SELECTED, "").view("map", map)
      .view("camera", camera).view("plot", plot);
  private final ArrangeHistory history = new ArrangeHistory();
  private final List<String> asked = new ArrayList<>();
  private Theme theme;
  private Shell shell;

  @BeforeEach
  void open() {
    theme = Themes.dark(TestDisplay.get());
    shell = new Shell(TestDisplay.get(), SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setBounds(0, 0, 800, 600);
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  private RuicSurface show(Layout layout) {
    ruic.laidOut(layout);
    RuicSurface surface = new RuicSurface(shell, theme, ruic, history, () -> asked.add("add"));
    shell.open();
    shell.layout(true, true);
    return surface;
  }

  private Arrangement now() {
    return ruic.arranging().now();
  }

  private static <C extends Control> C find(Composite above, Class<C> type) {
    return Controls.all(above, type).getFirst();
  }

  private TitleLine line(RuicSurface surface, String view) {
    return surface.docking().now().windows().isEmpty() ? Controls.all(surface, ViewStack.class).stream()
        .filter(stack -> stack.ids().contains(view)).findFirst().orElseThrow().line()
        : Arrays.stream(TestDisplay.get().getShells())
            .flatMap(s -> Controls.all(s, ViewStack.class).stream()).filter(stack -> stack.ids().contains(view))
            .findFirst().orElseThrow().line();
  }

  /** Presses a title, moves the pointer to a place of another control, and lets go. */
  private void drag(RuicSurface surface, String view, Control to, int x, int y) {
    TitleLine from = line(surface, view);
    Point target = from.toControl(to.toDisplay(x, y));
    send(from, SWT.MouseDown, 20, 10, 0, 1);
    send(from, SWT.MouseMove, (20 + target.x) / 2, (10 + target.y) / 2, SWT.BUTTON1, 0);
    send(from, SWT.MouseMove, target.x, target.y, SWT.BUTTON1, 0);
    send(from, SWT.MouseUp, target.x, target.y, SWT.BUTTON1, 1);
    shell.layout(true, true);
  }

  private static Control stack(PaintedView view) {
    Control at = view.control;
    while (!(at instanceof ViewStack)) {
      at = at.getParent();
    }
    return at;
  }

  private static void send(Control control, int type, int x, int y, int state, int button) {
    Event event = new Event();
    event.x = x;
    event.y = y;
    event.stateMask = state;
    event.button = button;
    event.count = 1;
    control.notifyListeners(type, event);
  }

  @Test
  void aViewIsDraggedBesideAnotherAndGoesOnAsItWas() {
    RuicSurface surface = show(ROW);
    Control painted = map.control;

    drag(surface, "map", camera.control, camera.control.getSize().x / 2, camera.control.getSize().y - 20);

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

    drag(surface, "camera", map.control, map.control.getSize().x / 2, map.control.getSize().y / 2);

    assertEquals(new Layout.Tabs(List.of("map", "plot", "camera"), 2), now().layout());
    assertTrue(camera.control.isVisible());
    surface.docking().undo();
    assertEquals(ROW, now().layout());
    surface.docking().redo();
    assertEquals(List.of("map", "plot", "camera"), now().layout().views());
  }

  @Test
  void aTabIsDraggedBeforeAnother() {
    RuicSurface surface = show(new Layout.Tabs(List.of("map", "plot", "camera")));
    TitleLine line = line(surface, "map");

    drag(surface, "map", line, line.getSize().x - 200, 10);

    assertEquals(List.of("plot", "camera", "map"), now().layout().views());
  }

  @Test
  void aViewIsDraggedAlongAWholeSide() {
    RuicSurface surface = show(ROW);

    drag(surface, "plot", surface, 400, surface.getSize().y - 4);

    assertEquals(Layout.Direction.COLUMN, ((Layout.Split) now().layout()).direction());
    assertTrue(Controls.all(surface, Aside.class).stream().noneMatch(Control::getVisible), "the frame is gone");
  }

  @Test
  void whatIsDroppedBesideTheWindowsHasAWindowOfItsOwnThatIsClosedWithTheView() {
    RuicSurface surface = show(ROW);

    drag(surface, "camera", surface, 900, 300);

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
    RuicSurface surface = show(ROW);
    TitleLine from = line(surface, "map");
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
    RuicSurface surface = show(ROW);
    TitleLine from = line(surface, "map");
    send(from, SWT.MouseDown, 20, 10, 0, 1);
    send(from, SWT.MouseMove, 23, 12, SWT.BUTTON1, 0);
    send(from, SWT.MouseUp, 23, 12, SWT.BUTTON1, 1);

    assertEquals(ROW, now().layout());
  }

  @Test
  void aDoubleClickHasAViewTakeTheWholeWindow() {
    RuicSurface surface = show(ROW);
    send(line(surface, "camera"), SWT.MouseDoubleClick, 20, 10, 0, 1);
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
    send(line(surface, "camera"), SWT.MouseDown, 20, 10, 0, 2);

    assertEquals(List.of("map", "plot"), now().views());
    assertTrue(camera.control.isDisposed());
    surface.docking().open("camera");
    assertEquals(List.of("map", "plot", "camera"), now().views());
  }

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
  void theFrontTabIsKeptAndIsNoStepOfItsOwn() {
    RuicSurface surface = show(ROW);
    send(line(surface, "plot"), SWT.KeyDown, 0, 0, 0, 0);
    Event right = new Event();
    right.keyCode = SWT.ARROW_RIGHT;
    line(surface, "plot").notifyListeners(SWT.KeyDown, right);

    assertEquals(new Layout.Tabs(List.of("map", "plot"), 1), ((Layout.Split) now().layout()).parts().getFirst());
    assertFalse(surface.docking().canUndo());
    assertTrue(plot.control.isVisible());
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
