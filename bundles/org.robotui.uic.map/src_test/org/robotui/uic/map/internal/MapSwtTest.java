package org.robotui.uic.map.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Set;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.widgets.Display;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.port.InputState;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.scene.KeptViewport;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class MapSwtTest {
  private static final char ESCAPE = SWT.ESC;
  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
  /** Half as much again as it is; a picture made anew for each paint would be a million more. */
  private static final long MOST_PAINT_BYTES = 550_000;
  private final Display display = TestDisplay.get();
  private Theme theme;
  private MapStage stage;

  @BeforeEach
  void open() {
    theme = Themes.dark(display);
    stage = room();
  }

  @AfterEach
  void close() {
    stage.close();
    theme.dispose();
  }

  @Test
  void wallsEchoesWayAndRobotAreSeen() {
    Set<RGB> colours = colours(stage.picture());
    assertTrue(colours.contains(theme.palette().rgb(Role.WALL)), "walls");
    assertTrue(colours.contains(theme.palette().rgb(Role.LASER)), "echoes");
    assertTrue(colours.contains(theme.palette().rgb(Role.PLAN)), "plan");
  }

  @Test
  void hiddenLayersAreNotSeen() {
    stage.context.settings().set(MapOptions.show("scan"), false);
    stage.tick();
    assertFalse(colours(stage.picture()).contains(theme.palette().rgb(Role.LASER)));
  }

  @Test
  void whatLayersSayStandsOnAGroundOfItsOwn() {
    RGB edge = theme.palette().rgb(Role.LINE);
    assertFalse(atUpperLeft(stage.picture()).contains(edge), "nothing to say");
    stage.context.input(MapPorts.SCAN).state(DemoRoom.source("scan"), new InputState.Stale(2.1, "late"));
    stage.tick();
    assertTrue(atUpperLeft(stage.picture()).contains(edge));
  }

  /** What is seen on a short way from the left, through the edge of such a ground into it. */
  private static Set<RGB> atUpperLeft(ImageData picture) {
    Set<RGB> seen = new HashSet<>();
    for (int x = Theme.EDGE - 2; x < Theme.EDGE + 3; x++) {
      seen.add(picture.palette.getRGB(picture.getPixel(x, 2 * Theme.EDGE)));
    }
    return seen;
  }

  @Test
  void everyStateLooksDifferent() {
    Set<Integer> pictures = new HashSet<>();
    pictures.add(hash());
    stage.context.input(MapPorts.SCAN).state(DemoRoom.source("scan"), new InputState.Stale(2.1, "late"));
    stage.tick();
    pictures.add(hash());
    stage.close();
    stage = new MapStage(display, theme, 600, 400);
    stage.open();
    stage.tick();
    pictures.add(hash());
    stage.context.input(MapPorts.SCAN).state(new InputState.Waiting("for the first scan"));
    stage.tick();
    pictures.add(hash());
    stage.context.input(MapPorts.SCAN).state(new InputState.Failed("refused"));
    stage.tick();
    pictures.add(hash());
    assertEquals(5, pictures.size());
  }

  @Test
  void theWheelZoomsAndADoubleClickShowsAllAgain() {
    String before = stage.note();
    stage.wheel(3, 200, 150);
    stage.tick();
    assertNotEquals(before, stage.note());
    stage.mouse(SWT.MouseDoubleClick, 1, 200, 150);
    stage.tick();
    assertEquals(before, stage.note());
  }

  @Test
  void theNextMapIsSeenFromWhereThisOneWasLeft() {
    stage.wheel(3, 200, 150);
    stage.mouse(SWT.MouseDown, 1, 200, 150);
    stage.mouse(SWT.MouseMove, 0, 260, 190);
    stage.mouse(SWT.MouseUp, 1, 260, 190);
    String before = stage.note();
    stage.canvas().dispose();
    Object left = stage.context.settings().current().values().get(KeptViewport.CAMERA);
    MapStage next = room();
    next.context.settings().set(KeptViewport.CAMERA, left);
    next.replace();
    next.open();
    next.tick();
    assertEquals(before, next.note());
    next.close();
  }

  @Test
  void draggingMovesTheMapAndEndsFollowing() {
    stage.key('f');
    assertTrue(stage.context.settings().current().flag(MapOptions.FOLLOW));
    int before = hash();
    stage.mouse(SWT.MouseDown, 1, 200, 150);
    stage.mouse(SWT.MouseMove, 0, 260, 190);
    stage.mouse(SWT.MouseUp, 1, 260, 190);
    assertFalse(stage.context.settings().current().flag(MapOptions.FOLLOW));
    assertNotEquals(before, hash());
  }

  @Test
  void followingIsSaidInTheTitleLine() {
    stage.act("follow");
    stage.tick();
    assertTrue(stage.note().startsWith("follow  \u00b7  map"), stage.note());
  }

  @Test
  void aGoalIsPressedAndDragged() {
    stage.act("goal");
    stage.mouse(SWT.MouseDown, 1, 300, 200);
    stage.mouse(SWT.MouseMove, 0, 300, 120);
    stage.mouse(SWT.MouseUp, 1, 300, 120);
    NavigationGoal goal = stage.context.output(MapPorts.GOAL).sent().getFirst().command();
    assertEquals(DemoRoom.MAP, goal.frame());
    assertEquals(Math.PI / 2, goal.pose().rotation().yaw(), 1e-6);
    assertFalse(stage.checked("goal"), "the tool is put away after use");
  }

  @Test
  void escapeEndsAToolWithoutSending() {
    stage.key('g');
    assertTrue(stage.checked("goal"));
    stage.mouse(SWT.MouseDown, 1, 300, 200);
    stage.key(ESCAPE);
    stage.mouse(SWT.MouseUp, 1, 300, 200);
    assertFalse(stage.checked("goal"));
    assertTrue(stage.context.output(MapPorts.GOAL).sent().isEmpty());
  }

  @Test
  void theMeasureStaysUntilTheToolEnds() {
    int before = hash();
    stage.key('m');
    stage.mouse(SWT.MouseDown, 1, 100, 100);
    stage.mouse(SWT.MouseUp, 1, 200, 100);
    stage.mouse(SWT.MouseExit, 0, 0, 0);
    assertNotEquals(before, hash());
    stage.key(ESCAPE);
    assertEquals(before, hash());
  }

  @Test
  void paintingARoomAllocatesLittleAndHappensOnceWhereItIsAskedFor() {
    stage.tick();
    long before = stage.canvas().paints();
    long[] bytes = new long[20];
    for (int i = 0; i < bytes.length; i++) {
      long start = THREADS.getCurrentThreadAllocatedBytes();
      stage.settle();
      bytes[i] = THREADS.getCurrentThreadAllocatedBytes() - start;
    }
    Arrays.sort(bytes);
    assertEquals(bytes.length, stage.canvas().paints() - before);
    assertTrue(bytes[bytes.length / 2] < MOST_PAINT_BYTES,
        () -> "painting allocates " + Arrays.toString(bytes) + " bytes");
  }

  @Test
  void fiftyTimesOpenedAndClosedLeavesNothingBehind() {
    stage.close();
    cycle();
    int before = display.getDeviceData().objects.length;
    for (int i = 0; i < 50; i++) {
      cycle();
    }
    assertEquals(before, display.getDeviceData().objects.length);
    stage = room();
  }

  private void cycle() {
    MapStage once = room();
    once.mouse(SWT.MouseMove, 0, 100, 100);
    once.act("measure");
    once.wheel(-3, 100, 100);
    once.close();
  }

  private MapStage room() {
    MapStage made = new MapStage(display, theme, 640, 420);
    DemoRoom.fill(made.context, System.nanoTime());
    made.replace();
    made.open();
    made.tick();
    made.tick();
    return made;
  }

  private int hash() {
    return Arrays.hashCode(stage.picture().data);
  }

  private static Set<RGB> colours(ImageData picture) {
    Set<RGB> colours = new HashSet<>();
    for (int y = 0; y < picture.height; y++) {
      for (int x = 0; x < picture.width; x++) {
        colours.add(picture.palette.getRGB(picture.getPixel(x, y)));
      }
    }
    return colours;
  }
}
