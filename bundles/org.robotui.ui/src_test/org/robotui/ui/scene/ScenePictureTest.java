package org.robotui.ui.scene;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.stream.IntStream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.CanvasHands;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class ScenePictureTest {
  private static final int LAYERS = 5;

  private final Display display = TestDisplay.get();
  private final Theme theme = Themes.dark(display);
  private final Scene scene = new Scene();
  private Viewport viewport = new Viewport(0, 0, 10, 200, 150);
  private Shell shell;
  private PaintedCanvas canvas;
  private ScenePicture picture;
  private boolean slow = true;
  private boolean disposed;
  private int painted;
  private long spent;

  /** A square that takes five milliseconds, by the clock of the picture. */
  private final class Square implements Entity {
    private final int number;
    private boolean gone;

    Square(int number) {
      this.number = number;
    }

    @Override
    public void paint(Painter painter) {
      assertFalse(gone, "a layer that was removed is painted no more");
      painted++;
      painter.fill(theme.traces().get(number)).area(new double[]{number, 0, number + 2, 0, number + 2, 2, number, 2},
          4);
      spent += slow ? 5_000_000 : 0;
    }

    @Override
    public Optional<Bounds> bounds() {
      return Optional.empty();
    }

    @Override
    public Optional<Description> describeAt(double x, double y, double tolerance) {
      return Optional.empty();
    }

    @Override
    public void dispose() {
      gone = true;
      disposed = true;
    }
  }

  @BeforeEach
  void open() {
    IntStream.range(0, LAYERS).forEach(i -> scene.add(new Layer("square" + i, i, "square", new Square(i))));
    shell = new Shell(display, SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setSize(viewport.width(), viewport.height());
    canvas = new PaintedCanvas(shell, theme, (gc, area) -> picture.paint(new Painter(gc, viewport, theme)));
    picture = new ScenePicture(scene, canvas, theme, () -> System.nanoTime() + spent);
    shell.open();
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  private CanvasHands hands() {
    return new CanvasHands(canvas, canvas::paints, canvas::requestPaint);
  }

  private void await() {
    TestDisplay.until(picture::upToDate);
  }

  private void paintOften() {
    for (int i = 0; i < 4; i++) {
      hands().settle();
    }
    await();
  }

  private void count(int[] others) {
    others[0]++;
    if (!picture.upToDate()) {
      display.asyncExec(() -> count(others));
    }
  }

  @Test
  void whatTakesLongIsPaintedInTurnsBetweenWhichOthersAreServed() {
    paintOften();
    int[] others = {0};
    picture.refresh();
    count(others);
    await();
    assertTrue(others[0] >= LAYERS, others[0] + " others were served");
  }

  @Test
  void itLooksTheSame() {
    hands().settle();
    byte[] direct = CanvasHands.picture(canvas).data;
    paintOften();
    int before = painted;
    hands().settle();
    assertEquals(before, painted, "what is there is shown");
    assertArrayEquals(direct, CanvasHands.picture(canvas).data);
  }

  @Test
  void aCameraThatMovesIsFollowedAtOnce() {
    paintOften();
    int before = painted;
    viewport = viewport.panned(7, 3);
    hands().settle();
    assertTrue(painted >= before + LAYERS);
    byte[] moved = CanvasHands.picture(canvas).data;
    await();
    hands().settle();
    assertArrayEquals(moved, CanvasHands.picture(canvas).data);
  }

  @Test
  void whatIsRemovedBetweenTwoTurnsIsNotPainted() {
    paintOften();
    picture.refresh();
    for (int before = painted; painted == before;) {
      display.readAndDispatch();
    }
    assertFalse(picture.upToDate());
    scene.remove("square" + (LAYERS - 1));
    scene.release();
    assertTrue(disposed);
    await();
  }

  @Test
  void whatIsQuickAgainIsPaintedAsItIs() {
    paintOften();
    slow = false;
    picture.refresh();
    await();
    int before = painted;
    hands().settle();
    assertEquals(before + LAYERS, painted);
  }

  @Test
  void nothingIsLeftOfItHoweverFarItCame() {
    shell.dispose();
    int resources = display.getDeviceData().objects.length;
    for (int turns = 0; turns < 4; turns++) {
      open(turns);
    }
    assertEquals(resources, display.getDeviceData().objects.length);
  }

  private void open(int turns) {
    scene.layers().forEach(l -> scene.remove(l.id()));
    open();
    paintOften();
    picture.refresh();
    for (int i = 0; i < turns; i++) {
      display.readAndDispatch();
    }
    shell.dispose();
    while (display.readAndDispatch()) {
      Thread.onSpinWait();
    }
  }
}
