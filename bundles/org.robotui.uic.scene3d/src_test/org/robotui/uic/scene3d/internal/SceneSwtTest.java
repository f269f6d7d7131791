package org.robotui.uic.scene3d.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Menu;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Eye;
import org.robotui.gl.render.Pick;
import org.robotui.gl.render.Rendered;
import org.robotui.gl.shape.Describer;
import org.robotui.gl.shape.Handle;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.Properties;
import org.robotui.gl.shape.Ray;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.display.DisplayCodec;
import org.robotui.ui.display.DisplaySpec;
import org.robotui.uic.scene3d.internal.model.FakeKind;
import org.robotui.uic.scene3d.internal.render.FakeGl;
import org.robotui.uic.scene3d.internal.waypoint.Route;
import org.robotui.uic.scene3d.internal.waypoint.Waypoints;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class SceneSwtTest {
  private static final FrameId MAP = new FrameId("a", "map");
  private static final FrameId BASE = new FrameId("a", "base_link");
  private static final SourceId POSE = new SourceId("base", "/pose");

  private final Display display = TestDisplay.get();
  private final FakeGl gl = new FakeGl();
  private final FakeKind grid = new FakeKind("grid", List.of());
  private final FakeKind pose = new FakeKind("pose", List.of(PoseEstimate.class));
  private Theme theme;
  private SceneWindow window;

  @BeforeEach
  void open() {
    theme = Themes.dark(display);
    gl.atOnce = true;
    window = new SceneWindow(display, theme, 800, 500, List.of(grid, pose), () -> Optional.of(gl));
    window.frames.fix(MAP, BASE, RigidTransform.planar(1, 2, 0));
    window.context.input(ScenePorts.DATA).candidates(List.of(new Input.Candidate(POSE, "PoseEstimate")));
    window.tick();
    window.context.input(ScenePorts.DATA)
        .put(POSE, new PoseEstimate(BASE, RigidTransform.IDENTITY, Doubles.wrap(new double[0])), System.nanoTime(),
            Optional.empty());
    window.tick();
    window.hands().settle();
  }

  @AfterEach
  void close() {
    window.close();
    theme.dispose();
  }

  private Vector3 eye() {
    return gl.requests.getLast().eye().fixedFromEye().translation();
  }

  @Test
  void thePictureFillsTheCanvasInTheColourOfTheGround() {
    ImageData picture = window.picture();
    assertEquals(theme.palette().rgb(Role.GROUND), rgb(picture, picture.width * 2 / 3, picture.height / 2));
    assertEquals(2, gl.requests.getLast().parts().size());
    assertEquals(window.canvas().getSize().x, gl.requests.getLast().width());
  }

  @Test
  void aDragTurnsTheWheelZoomsAndShiftPans() {
    Vector3 before = eye();
    drag(1, 0, 300, 200, 340, 210);
    Vector3 turned = eye();
    assertNotEquals(before, turned);
    window.hands().wheel(1, 300, 200);
    Vector3 nearer = eye();
    assertNotEquals(turned, nearer);
    double tilt = gl.requests.getLast().eye().fixedFromEye().rotation().pitch();
    drag(1, SWT.SHIFT, 300, 200, 340, 240);
    assertNotEquals(nearer, eye());
    assertEquals(tilt, gl.requests.getLast().eye().fixedFromEye().rotation().pitch(), 1e-12);
  }

  @Test
  void aMeasureIsDraggedAndTheCameraStands() {
    Vector3 before = eye();
    window.hands().key('m');
    drag(1, 0, 300, 300, 500, 300);
    assertTrue(
        window.until(() -> rgb(window.picture(), window.canvas().getLocation().x + 400, 300)
            .equals(theme.palette().rgb(Role.ACCENT))),
        "a line between both ends");
    assertEquals(before, eye());
    window.hands().key((char) SWT.ESC);
    drag(1, 0, 300, 300, 500, 300);
    assertNotEquals(before, eye(), "without the tool a drag turns");
  }

  @Test
  void keysChangeTheCamera() {
    window.hands().key('3');
    window.until(() -> gl.requests.getLast().eye().projection() instanceof Eye.Projection.Parallel);
    assertTrue(gl.requests.getLast().eye().projection() instanceof Eye.Projection.Parallel);
  }

  @Test
  void aClickSelectsAndTheSelectionIsMarked() {
    hit(new Part("line0", FakeKind.line(0).shape(), RigidTransform.IDENTITY, FakeKind.line(0).material(),
        (element, place) -> Properties.of("A line", new Properties.Entry("element", Integer.toString(element)))));
    click(300, 200);
    window.tick();
    window.tick();
    assertEquals(List.of("line0"), gl.requests.getLast().selection().stream().map(s -> s.part()).toList());
    window.hands().key((char) SWT.ESC);
    gl.hit = Optional.empty();
    click(300, 200);
    window.tick();
    window.tick();
    assertEquals(List.of(), gl.requests.getLast().selection());
  }

  /** Where the words at the top begin, by the first pixel of their edge or letters in a row. */
  private int banner() {
    ImageData picture = window.picture();
    int left = window.canvas().getLocation().x;
    RGB ground = theme.palette().rgb(Role.GROUND);
    for (int x = left; x < picture.width; x++) {
      if (!rgb(picture, x, 24).equals(ground)) {
        return x;
      }
    }
    return picture.width;
  }

  @Test
  void theWordsOfAToolMakeRoomForTheCardOfTheSelection() {
    window.shell.setSize(1200, 500);
    window.hands().settle();
    window.tick();
    window.act("measure");
    int alone = banner();
    window.act("measure");
    hit(FakeKind.line(0));
    click(300, 200);
    window.tick();
    window.tick();
    window.act("measure");
    window.tick();
    assertTrue(banner() < alone - 100, () -> banner() + " and " + alone);
  }

  @Test
  void aHandleIsDraggedAndTheCameraStands() {
    AtomicInteger drags = new AtomicInteger();
    AtomicInteger clicks = new AtomicInteger();
    Handle handle = new Handle() {
      @Override
      public void press(Ray ray, Vector3 place) {
        // Counted by what follows.
      }

      @Override
      public void drag(Ray ray) {
        drags.incrementAndGet();
      }

      @Override
      public void release(boolean clicked) {
        clicks.addAndGet(clicked ? 1 : 0);
      }
    };
    pose.parts = List.of(handled(handle));
    window.tick();
    hit(handled(handle));
    // Ends the way to the first view, and any other, so that only hands could move the camera.
    window.hands().wheel(1, 300, 200);
    window.tick();
    Vector3 before = eye();
    drag(1, 0, 300, 200, 340, 230);
    window.tick();
    assertTrue(drags.get() > 0);
    assertEquals(0, clicks.get());
    assertEquals(before, eye());
    click(300, 200);
    window.tick();
    assertEquals(1, clicks.get());
  }

  private static Part handled(Handle handle) {
    return new Part("h", FakeKind.line(0).shape(), RigidTransform.IDENTITY, FakeKind.line(0).material(),
        Describer.of("handle"), Optional.of(handle));
  }

  @Test
  void aGoalIsPointedOutOnTheFloor() {
    window.act("goal");
    drag(1, 0, 300, 300, 380, 300);
    assertEquals(1, window.context.output(ScenePorts.GOAL).sent().size());
    assertEquals(MAP, window.context.output(ScenePorts.GOAL).sent().getFirst().command().frame());
    assertEquals(0, window.context.output(ScenePorts.GOAL).sent().getFirst().command().pose().translation().z(), 1e-9);
  }

  private List<Part> marks() {
    return gl.requests.getLast().parts().getOrDefault(Waypoints.DISPLAY, List.of());
  }

  private void place(int x, int y) {
    drag(1, 0, x, y, x + 60, y);
    window.tick();
    window.tick();
  }

  private Route route() {
    return Route.read(window.context.settings().current());
  }

  @Test
  void waypointsArePlacedMovedAndRemovedByMouseAndKeys() {
    gl.hit = Optional.empty();
    window.act("waypoints");
    place(300, 300);
    place(350, 330);
    assertEquals(2, route().poses().size());
    assertEquals(Optional.of(MAP), route().frame());
    assertTrue(window.until(() -> marks().size() == 7));
    RigidTransform first = route().poses().getFirst();
    Part disc = marks().getFirst();
    gl.hit = Optional.of(new Pick(Waypoints.DISPLAY, disc, 0, first.translation()));
    drag(1, 0, 300, 300, 340, 320);
    window.tick();
    assertNotEquals(first.translation(), route().poses().getFirst().translation());
    assertEquals(first.rotation(), route().poses().getFirst().rotation());
    assertEquals(2, route().poses().size(), "a press on a waypoint adds none");
    key(SWT.PAGE_DOWN, 0);
    window.tick();
    assertEquals(first.rotation(), route().poses().getLast().rotation());
    key('z', SWT.MOD1);
    key('z', SWT.MOD1);
    window.tick();
    assertEquals(first, route().poses().getFirst());
    key(SWT.DEL, 0);
    window.tick();
    assertEquals(1, route().poses().size());
  }

  @Test
  void enterDrivesToTheWaypointsAndTheStopEndsIt() {
    gl.hit = Optional.empty();
    window.act("waypoints");
    place(300, 300);
    place(350, 330);
    key(SWT.CR, 0);
    window.tick();
    RigidTransform first = route().poses().getFirst();
    assertEquals(List.of(first),
        window.context.output(ScenePorts.GOAL).sent().stream().map(s -> s.command().pose()).toList());
    window.frames.fix(MAP, BASE, first);
    window.tick();
    assertEquals(route().poses(),
        window.context.output(ScenePorts.GOAL).sent().stream().map(s -> s.command().pose()).toList());
    window.context.authority().stop(FakeAuthority.ANNA);
    window.tick();
    window.frames.fix(MAP, BASE, route().poses().getLast());
    window.tick();
    assertEquals(2, window.context.output(ScenePorts.GOAL).sent().size());
  }

  private void key(int code, int mask) {
    Event event = new Event();
    event.keyCode = code;
    event.stateMask = mask;
    window.canvas().notifyListeners(SWT.KeyDown, event);
    window.turn();
    window.tick();
  }

  @Test
  void aBoxInTheListSwitchesADisplay() {
    assertTrue(gl.requests.getLast().parts().containsKey("grid"));
    window.flip(0);
    window.tick();
    window.tick();
    assertFalse(gl.requests.getLast().parts().containsKey("grid"));
  }

  @Test
  void whatIsAddedIsChosenAndShowsItsSettings() {
    List<Menu> menus = new ArrayList<>();
    display.addFilter(SWT.Show, e -> menus.addAll(e.widget instanceof Menu menu ? List.of(menu) : List.of()));
    window.press("Add a display");
    window.until(() -> !menus.isEmpty());
    assertFalse(window.settingsSeen());
    menus.getLast().getItem(0).notifyListeners(SWT.Selection, new Event());
    menus.getLast().setVisible(false);
    assertTrue(window.until(window::settingsSeen));
    assertEquals(List.of("grid", "pose", "grid"), DisplayCodec
        .read(window.context.settings().current(), SceneOptions.DISPLAYS).stream().map(DisplaySpec::type).toList());
    window.flipChosen();
    window.tick();
    assertEquals(List.of(true, true, false), DisplayCodec
        .read(window.context.settings().current(), SceneOptions.DISPLAYS).stream().map(DisplaySpec::shown).toList());
  }

  @Test
  void theListOpensAndCloses() {
    int wide = window.canvas().getSize().x;
    window.act("displays");
    assertTrue(window.canvas().getSize().x > wide);
    window.act("displays");
    assertEquals(wide, window.canvas().getSize().x);
  }

  @Test
  void withoutOpenGlTheReasonAndTheRemedyAreSaid() {
    gl.none = Optional.of(new Rendered.Unavailable("No OpenGL 3.3.", "Install libgl1-mesa-dri."));
    window.hands().wheel(1, 200, 200);
    window.tick();
    ImageData picture = window.picture();
    int middle = window.canvas().getLocation().x + window.canvas().getSize().x / 2;
    boolean words = false;
    for (int x = middle - 80; x < middle + 80; x++) {
      words |= !rgb(picture, x, picture.height / 2 + 10).equals(theme.palette().rgb(Role.GROUND));
    }
    assertTrue(words);
  }

  @Test
  void atTheEndTheRendererAndTheDisplaysAreGivenBack() {
    window.close();
    assertEquals(0, gl.open);
    assertEquals(0, grid.open);
    assertEquals(0, pose.open);
  }

  private void hit(Part part) {
    gl.hit = Optional.of(new Pick("pose:base/pose", part, 7, new Vector3(1, 2, 0)));
  }

  private void click(int x, int y) {
    window.hands().mouse(SWT.MouseDown, 1, x, y);
    window.turn();
    window.hands().mouse(SWT.MouseUp, 1, x, y);
    window.turn();
  }

  private void drag(int button, int mask, int fromX, int fromY, int toX, int toY) {
    Event down = new Event();
    down.x = fromX;
    down.y = fromY;
    down.button = button;
    down.stateMask = mask;
    window.canvas().notifyListeners(SWT.MouseDown, down);
    window.turn();
    window.hands().mouse(SWT.MouseMove, 0, (fromX + toX) / 2, (fromY + toY) / 2);
    window.hands().mouse(SWT.MouseMove, 0, toX, toY);
    window.hands().mouse(SWT.MouseUp, button, toX, toY);
    window.turn();
  }

  private static RGB rgb(ImageData picture, int x, int y) {
    return picture.palette.getRGB(picture.getPixel(x, y));
  }
}
