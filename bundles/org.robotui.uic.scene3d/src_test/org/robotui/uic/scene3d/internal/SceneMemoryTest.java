package org.robotui.uic.scene3d.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Display;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.uic.scene3d.internal.model.FakeKind;

/** What a scene takes while its camera turns, and what is left of many scenes: with real OpenGL. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class SceneMemoryTest {
  private static final int WIDTH = 1000;
  private static final int HEIGHT = 600;
  private static final int PICTURES = 100;
  private static final int FIRST = 50;
  private static final int ALL = 200;
  private static final int PATIENCE_MS = 60_000;
  private static final long MIB = 1 << 20;

  private final Display display = TestDisplay.get();
  private final Theme theme = Themes.dark(display);
  private final HeldGl gl = new HeldGl();
  private final CountedGl counted = new CountedGl(gl, new AtomicLong());
  private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
  private Optional<SceneWindow> shown = Optional.empty();
  private int moves;

  @AfterEach
  void close() {
    shown.ifPresent(SceneWindow::close);
    gl.close();
    theme.dispose();
  }

  /** A scene with its first picture. */
  private SceneWindow open(int width, int height) {
    long before = counted.pictures().get();
    SceneWindow window = new SceneWindow(display, theme, width, height, List.of(new FakeKind("grid", List.of())),
        () -> Optional.of(counted));
    assertTrue(window.until(() -> counted.pictures().get() > before), "no picture came");
    return window;
  }

  /** Turns the camera by the mouse, each time as soon as the picture before is there. */
  private void turn(SceneWindow window, int pictures) {
    for (int i = 0; i < pictures; i++) {
      long wanted = counted.pictures().get() + 1;
      long deadline = System.nanoTime() + PATIENCE_MS * 1_000_000L;
      while (counted.pictures().get() < wanted && System.nanoTime() < deadline) {
        moves++;
        window.hands().mouse(SWT.MouseMove, 0, 303 + moves % 40 * 3, 300);
        awaitFor(200, () -> counted.pictures().get() >= wanted);
      }
      assertTrue(counted.pictures().get() >= wanted, "no picture came");
    }
  }

  /** What is pressed must be known before the camera is turned: a move may be for nothing. */
  private void awaitFor(int milliseconds, BooleanSupplier done) {
    boolean[] over = new boolean[1];
    Runnable bell = () -> over[0] = true;
    display.timerExec(milliseconds, bell);
    while (!done.getAsBoolean() && !over[0]) {
      if (!display.readAndDispatch()) {
        Thread.onSpinWait();
      }
    }
    display.timerExec(-1, bell);
  }

  private long allocated() {
    long there = Thread.getAllStackTraces().keySet().stream()
        .filter(t -> t.getName().equals("OpenGL")).mapToLong(t -> threads.getThreadAllocatedBytes(t.threadId())).sum();
    return there + threads.getCurrentThreadAllocatedBytes();
  }

  @Test
  void aPictureMakesNoMoreGarbageThanTheToolkitNeedsOfIt() {
    SceneWindow window = open(WIDTH, HEIGHT);
    shown = Optional.of(window);
    window.hands().mouse(SWT.MouseDown, 1, 300, 300);
    turn(window, PICTURES / 4);
    long before = allocated();
    turn(window, PICTURES);
    long each = (allocated() - before) / PICTURES;
    long picture = 4L * window.canvas().getSize().x * window.canvas().getSize().y;
    assertTrue(each < picture + picture / 2, () -> each + " bytes for a picture of " + picture);
  }

  @Test
  void nothingIsLeftOfManyScenes() throws IOException {
    rounds(FIRST);
    long heap = heap();
    long resident = resident();
    int resources = resources();
    int running = Thread.activeCount();
    rounds(ALL - FIRST);
    // A picture may be in work still, which is thrown away when it is made.
    awaitFor(PATIENCE_MS, () -> resources() <= resources);
    assertTrue(resources() <= resources,
        () -> resources() + " and not " + resources + " images, fonts, colours of the toolkit");
    assertEquals(Map.of(), gl.held(), "objects of OpenGL");
    assertEquals(running, Thread.activeCount(), "threads");
    assertTrue(heap() < heap + 4 * MIB, "the heap grew from " + heap + " to " + heap());
    assertTrue(resident() < resident + 64 * MIB, "the process grew from " + resident + " to " + resident());
  }

  private int resources() {
    return display.getDeviceData().objects.length;
  }

  private void rounds(int count) {
    for (int i = 0; i < count; i++) {
      open(640, 480).close();
    }
  }

  /** After collections, which may be late: the least of some. */
  private static long heap() {
    long least = Long.MAX_VALUE;
    for (int i = 0; i < 4; i++) {
      System.gc();
      least = Math.min(least, ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed());
    }
    return least;
  }

  /** The memory of this process that is no file's. */
  private static long resident() throws IOException {
    return Files.readAllLines(Path.of("/proc/self/status")).stream().filter(line -> line.startsWith("RssAnon:"))
        .mapToLong(line -> Long.parseLong(line.replaceAll("\\D", "")) * 1024).sum();
  }
}
