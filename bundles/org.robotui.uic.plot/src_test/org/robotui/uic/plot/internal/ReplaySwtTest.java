package org.robotui.uic.plot.internal;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.robotui.testkit.KeptHistory.BEGIN;
import static org.robotui.testkit.KeptHistory.SECOND;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.Data;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.KeptHistory;
import org.robotui.testkit.KeptTimeline;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.uic.plot.internal.model.PlotOptions;

/** A plot of a recording of five minutes, as users handle it. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class ReplaySwtTest {
  private static final int WIDTH = 900;
  private static final int HEIGHT = 400;
  private static final int Y = 200;

  private final FakeUicContext context = new FakeUicContext("plot", new PlotType().schema());
  private final KeptTimeline timeline = new KeptTimeline();
  private Display display;
  private Theme theme;
  private Shell shell;
  private PlotUic uic;
  private String note = "";

  @BeforeEach
  void open() {
    FakeInput<Data> input = context.input(PlotType.VALUES);
    Robots.candidates(input);
    input.history(Robots.ODOM, Robots.run(new KeptHistory(timeline)));
    timeline.seek(BEGIN + 150 * SECOND);
    timeline.sought.clear();
    context.settings().set(PlotOptions.AXES, List.of(Map.of("traces", List.of("base./odom:linear.x"))));
    display = TestDisplay.get();
    theme = Themes.dark(display);
    shell = new Shell(display, SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setBounds(0, 0, WIDTH, HEIGHT);
    uic = (PlotUic) new PlotType().create(context, context.settings().current());
    uic.createControl(shell, UiContext.of(theme, text -> note = text));
    shell.open();
    step();
    step();
  }

  @AfterEach
  void close() {
    uic.close();
    shell.dispose();
    theme.dispose();
  }

  @Test
  void allIsSeenAtFirst() {
    assertTrue(note.endsWith("whole recording"), note);
    assertTrue(action("pause").checked().orElseThrow().getAsBoolean());
  }

  @Test
  void aClickGoesToThatTime() {
    click(200);
    click(400);
    double apart = (timeline.sought.get(1) - timeline.sought.get(0)) / (double) SECOND;
    assertTrue(apart > 50 && apart < 200, "200 points are " + apart + " s");
    assertTrue(note.endsWith("whole recording"), note);
  }

  @Test
  void aClickOnACurveGoesToTheTimeOfThatPoint() {
    context.settings().set(PlotOptions.AXES,
        List.of(Map.of("x", "base./odom:pose.translation.x", "traces", List.of("base./odom:pose.translation.y"))));
    step();
    step();
    click(5); // the figures: nothing is there
    assertEquals(List.of(), timeline.sought);
    for (int x = 60; x < WIDTH - 240 && timeline.sought.isEmpty(); x += 10) {
      click(x);
    }
    assertEquals(1, timeline.sought.size(), "some of these places are near the curve");
    assertTrue(note.endsWith("whole recording"), note);
  }

  @Test
  void aDoubleClickTakesItsFirstClickBackAndShowsAll() {
    key('+');
    step();
    assertTrue(note.endsWith("part of the recording"), note);
    click(300);
    mouse(SWT.MouseDoubleClick, 300, 1, 0);
    step();
    assertEquals(BEGIN + 150 * SECOND, timeline.state().position());
    assertTrue(note.endsWith("whole recording"), note);
  }

  @Test
  void aDragMovesWhatIsSeenAndNotTheTimeline() {
    mouse(SWT.MouseDown, 200, 1, 0);
    mouse(SWT.MouseMove, 260, 0, SWT.BUTTON1);
    mouse(SWT.MouseUp, 260, 1, SWT.BUTTON1);
    step();
    assertEquals(List.of(), timeline.sought);
    assertTrue(note.endsWith("part of the recording"), note);
  }

  @Test
  void theLineOfThePositionIsDragged() {
    int x = position();
    mouse(SWT.MouseDown, x, 1, 0);
    mouse(SWT.MouseMove, x + 40, 0, SWT.BUTTON1);
    mouse(SWT.MouseMove, x + 80, 0, SWT.BUTTON1);
    mouse(SWT.MouseUp, x + 80, 1, SWT.BUTTON1);
    step();
    assertEquals(2, timeline.sought.size());
    assertTrue(timeline.sought.getLast() > BEGIN + 160 * SECOND, timeline.sought.toString());
    assertTrue(Math.abs(position() - x - 80) <= 1, "from " + x + " to " + position());
    assertTrue(note.endsWith("whole recording"), note);
  }

  @Test
  void whatIsSeenGoesAlongWithThePosition() {
    action("pause").run().run();
    assertTrue(note.endsWith("follows the recording"), note);
    assertFalse(action("pause").checked().orElseThrow().getAsBoolean());
    step();
    int middle = position();
    timeline.seek(BEGIN + 250 * SECOND);
    step();
    assertEquals(middle, position());
    action("pause").run().run();
    assertTrue(note.endsWith("part of the recording"), note);
    timeline.seek(BEGIN + 255 * SECOND);
    step();
    assertTrue(position() > middle, "it stays");
    action("live").run().run();
    assertTrue(note.endsWith("whole recording"), note);
  }

  @Test
  void thePointerIsToldAndWhereItIsElsewhereIsShown() {
    mouse(SWT.MouseMove, 400, 0, 0);
    step();
    long here = context.pointed().elsewhere(this).orElseThrow();
    assertTrue(here > BEGIN && here < BEGIN + 300 * SECOND, Long.toString(here));
    mouse(SWT.MouseExit, 0, 0, 0);
    step();
    assertTrue(context.pointed().elsewhere(this).isEmpty());
    assertFalse(uic.tick(System.nanoTime()));
    byte[] before = pixels();
    context.pointed().point(this, BEGIN + 60 * SECOND);
    assertTrue(uic.tick(System.nanoTime()), "the line of the other pointer is to be painted");
    assertFalse(Arrays.equals(before, pixels()));
    context.pointed().leave(this);
    step();
    assertArrayEquals(before, pixels());
  }

  @Test
  void histogramsStandBelowAndAreOfWhatIsSeen() {
    int before = canvas().getSize().y;
    key('h');
    step();
    assertTrue(canvas().getSize().y < before);
    assertTrue(action("histograms").checked().orElseThrow().getAsBoolean());
    action("histograms").run().run();
    assertEquals(before, canvas().getSize().y);
  }

  private byte[] pixels() {
    Image image = picture();
    byte[] pixels = image.getImageData(100).data;
    image.dispose();
    return pixels;
  }

  @Test
  void statisticsStandBelow() {
    int before = canvas().getSize().y;
    key('s');
    step();
    assertTrue(canvas().getSize().y < before);
    action("statistics").run().run();
    assertEquals(before, canvas().getSize().y);
  }

  private ViewAction action(String id) {
    return uic.actions().stream().filter(a -> a.id().equals(id)).findFirst().orElseThrow();
  }

  private void click(int x) {
    mouse(SWT.MouseDown, x, 1, 0);
    mouse(SWT.MouseUp, x, 1, SWT.BUTTON1);
    step();
  }

  private void step() {
    uic.tick(System.nanoTime());
    uic.refresh();
    settle();
    picture().dispose();
  }

  private void mouse(int type, int x, int button, int state) {
    Event event = new Event();
    event.x = x;
    event.y = Y;
    event.button = button;
    event.stateMask = state;
    canvas().notifyListeners(type, event);
    settle();
  }

  private void key(int code) {
    Event event = new Event();
    event.keyCode = code;
    canvas().notifyListeners(SWT.KeyDown, event);
    settle();
  }

  private void settle() {
    boolean more = true;
    while (more) {
      more = display.readAndDispatch();
    }
  }

  private PaintedCanvas canvas() {
    for (Control each : ((Composite) shell.getChildren()[0]).getChildren()) {
      if (each instanceof PaintedCanvas found) {
        return found;
      }
    }
    throw new AssertionError("no canvas");
  }

  private Image picture() {
    Image image = new Image(display, WIDTH, HEIGHT);
    GC gc = new GC(image);
    canvas().print(gc);
    gc.dispose();
    return image;
  }

  /** The column of the line of the position: bright down to the bottom of the plot. */
  private int position() {
    mouse(SWT.MouseExit, 0, 0, 0);
    Image image = picture();
    ImageData data = image.getImageData(100);
    image.dispose();
    RGB bright = theme.palette().rgb(Role.TEXT);
    for (int x = 0; x < data.width - 240; x++) {
      int rows = 0;
      for (int y = 60; y < 300; y++) {
        rows += data.palette.getRGB(data.getPixel(x, y)).equals(bright) ? 1 : 0;
      }
      if (rows > 200) {
        return x + 1;
      }
    }
    throw new AssertionError("no line");
  }
}
