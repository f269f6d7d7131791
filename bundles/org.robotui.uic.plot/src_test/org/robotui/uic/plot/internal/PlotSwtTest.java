package org.robotui.uic.plot.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
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
import org.eclipse.swt.widgets.Text;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.port.InputState;
import org.robotui.data.Data;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewAction;
import org.robotui.ui.control.QuietButton;
import org.robotui.uic.plot.internal.model.PlotCodec;
import org.robotui.uic.plot.internal.model.PlotEngine;
import org.robotui.uic.plot.internal.model.PlotOptions;
import org.robotui.uic.plot.internal.model.PlotScene;
import org.robotui.uic.plot.internal.model.PlotSpec;
import org.robotui.uic.plot.internal.model.WholeSeries;
import org.robotui.uic.plot.internal.view.Exporter;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class PlotSwtTest {
  private static final int WIDTH = 900;
  private static final int HEIGHT = 400;
  private static final int X = 300;
  private static final int Y = 200;
  private static final String SPEED = "base./odom:linear.x";

  private final FakeUicContext context = new FakeUicContext("plot", new PlotType().schema());
  private final FakeInput<Data> input = context.input(PlotType.VALUES);
  private Display display;
  private Theme theme;
  private Shell shell;
  private PlotUic uic;
  private String note = "";

  @TempDir
  private Path folder;

  @BeforeEach
  void open() {
    context.settings().set(PlotOptions.TIME, PlotOptions.BY_RECEIPT);
    Robots.candidates(input);
    display = TestDisplay.get();
    theme = Themes.dark(display);
    shell = new Shell(display, SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setBounds(0, 0, WIDTH, HEIGHT);
    uic = (PlotUic) new PlotType().create(context, context.settings().current());
    uic.createControl(shell, UiContext.of(theme, text -> note = text));
    shell.open();
    step();
  }

  @AfterEach
  void close() {
    uic.close();
    shell.dispose();
    theme.dispose();
  }

  @Test
  void anEmptyViewInvitesToChooseAField() {
    QuietButton button = find(canvas(), QuietButton.class);
    assertTrue(button.isVisible());
    button.press();
    assertTrue(panel().isVisible());
    assertFalse(button.isVisible());
  }

  @Test
  void aSignalIsTypedAndKept() {
    action("add").run().run();
    Text field = find(panel(), Text.class);
    field.setText(SPEED);
    field.notifyListeners(SWT.DefaultSelection, new Event());
    assertEquals(List.of(SPEED), spec().signals().toList());
    assertEquals("", field.getText());
  }

  @Test
  void aSignalThatIsWrongStaysInTheFieldAndAddsNothing() {
    action("add").run().run();
    Text field = find(panel(), Text.class);
    field.setText("sine(" + SPEED + ")");
    field.notifyListeners(SWT.DefaultSelection, new Event());
    assertTrue(spec().isEmpty());
    assertEquals("sine(" + SPEED + ")", field.getText());
  }

  @Test
  void aFieldIsFoundInTheTreeByKeysAlone() {
    action("add").run().run();
    PaintedCanvas list = (PaintedCanvas) panel().getTabList()[1];
    keys(list, SWT.ARROW_RIGHT);
    step();
    assertTrue(input.chosen().contains(Robots.ODOM), "an open source is asked for");
    input.put(Robots.ODOM, Robots.odometry(0.3, 0), System.nanoTime(), Optional.empty());
    step();
    // Closed and opened again, it shows at once what was learned: frame, childFrame, pose, poseCovariance, linear.
    keys(list, SWT.ARROW_LEFT, SWT.ARROW_RIGHT);
    step();
    input.put(Robots.ODOM, Robots.odometry(0.3, 0), System.nanoTime(), Optional.empty());
    step();
    keys(list, SWT.ARROW_LEFT, SWT.ARROW_RIGHT, SWT.ARROW_DOWN, SWT.ARROW_DOWN, SWT.ARROW_DOWN, SWT.ARROW_DOWN,
        SWT.ARROW_DOWN,
        SWT.ARROW_RIGHT, SWT.ARROW_DOWN, SWT.CR);
    assertEquals(List.of(SPEED), spec().signals().toList());
  }

  @Test
  void aTraceIsDrawnInItsColour() {
    plot(SPEED);
    RGB blue = theme.traces().getFirst().getRGB();
    assertTrue(shows(blue));
    assertEquals("20\u00a0s \u00b7 live", note);
  }

  @Test
  void pauseHoldsWhatIsSeenWhileDataGoesOn() {
    plot(SPEED);
    action("pause").run().run();
    assertTrue(action("pause").checked().orElseThrow().getAsBoolean());
    assertEquals("20\u00a0s \u00b7 paused", note);
    input.put(Robots.ODOM, Robots.odometry(7, 0), System.nanoTime(), Optional.empty());
    assertTrue(uic.tick(System.nanoTime()), "the legend shows the newest value");
    action("live").run().run();
    assertEquals("20\u00a0s \u00b7 live", note);
  }

  @Test
  void aDragLooksBackAndADoubleClickReturns() {
    plot(SPEED);
    mouse(SWT.MouseDown, X, Y, 1, 0);
    mouse(SWT.MouseUp, X, Y, 1, 0);
    step();
    assertTrue(note.endsWith("live"), "a click alone holds nothing");
    mouse(SWT.MouseDown, X, Y, 1, 0);
    mouse(SWT.MouseMove, X + 50, Y, 0, SWT.BUTTON1);
    mouse(SWT.MouseUp, X + 50, Y, 1, 0);
    step();
    assertTrue(note.endsWith("paused"), note);
    mouse(SWT.MouseDoubleClick, X, Y, 1, 0);
    step();
    assertTrue(note.endsWith("live"), note);
  }

  @Test
  void theWheelZoomsTimeAndStaysLive() {
    plot(SPEED);
    wheel(3, 0);
    step();
    assertEquals("16\u00a0s \u00b7 live", note);
    wheel(-3, 0);
    step();
    assertEquals("20\u00a0s \u00b7 live", note);
  }

  @Test
  void aBoxIsZoomedInto() {
    plot(SPEED);
    mouse(SWT.MouseDown, 100, 100, 1, SWT.SHIFT);
    mouse(SWT.MouseMove, 200, 250, 0, SWT.SHIFT | SWT.BUTTON1);
    mouse(SWT.MouseUp, 200, 250, 1, SWT.SHIFT);
    step();
    assertTrue(note.endsWith("paused") && !note.startsWith("20"), note);
  }

  @Test
  void aClickOnItsNameHidesATrace() {
    plot(SPEED);
    pixels();
    mouse(SWT.MouseDown, WIDTH - 100, 20, 1, 0);
    mouse(SWT.MouseUp, WIDTH - 100, 20, 1, 0);
    assertTrue(spec().axes().getFirst().traces().getFirst().hidden());
    step();
    assertFalse(shows(theme.traces().getFirst().getRGB()));
  }

  @Test
  void valuesAreReadAtThePointerAndLegendsExplainThemselves() {
    plot(SPEED);
    int[] before = pixels();
    mouse(SWT.MouseMove, X, Y, 0, 0);
    assertFalse(Arrays.equals(before, pixels()));
    mouse(SWT.MouseMove, WIDTH - 100, 20, 0, 0);
    assertTrue(canvas().getToolTipText().startsWith(SPEED + " [m/s]"), canvas().getToolTipText());
  }

  @Test
  void cursorsComeAndGo() {
    plot(SPEED);
    keys(canvas(), 'c');
    assertTrue(action("cursors").checked().orElseThrow().getAsBoolean());
    keys(canvas(), 'c');
    assertFalse(action("cursors").checked().orElseThrow().getAsBoolean());
  }

  @Test
  void nothingIsPaintedWhereNothingIsNew() {
    step();
    assertFalse(uic.tick(System.nanoTime()));
  }

  @Test
  void everyStateCanBePainted() {
    plot(SPEED, "base./odom:nothing", "arm./joint_states:joints[0].position", "sine(x)");
    for (InputState state : List.of(new InputState.Waiting("w"), new InputState.Unconnected("u"),
        new InputState.Stale(2, "s"),
        new InputState.Failed("f"))) {
      input.state(state);
      long before = canvas().paints();
      step();
      pixels();
      assertTrue(canvas().paints() > before, state.toString());
    }
    context.settings().set(PlotOptions.LEGEND, "top");
    context.settings().set(PlotOptions.LINKED, false);
    context.settings().set(PlotOptions.STYLE, "dots");
    step();
    assertTrue(note.startsWith("2 without values"), note);
  }

  @Test
  void anySizeCanBePainted() {
    plot(SPEED, "base./odom:nothing", "arm./joint_states:joints[0].position");
    keys(canvas(), 'c');
    long before = canvas().paints();
    for (int[] size : new int[][]{{10, 10}, {60, 300}, {130, 40}, {600, 20}, {240, 180}, {1, 1}}) {
      shell.setSize(size[0], size[1]);
      settle();
      mouse(SWT.MouseMove, size[0] / 2, size[1] / 2, 0, 0);
      step();
      pixels();
    }
    assertTrue(canvas().paints() >= before + 6, "each was painted to its end");
  }

  @Test
  void tracesAreExported() throws IOException {
    plot(SPEED);
    Path file = folder.resolve("plot.csv");
    PlotEngine engine = new PlotEngine(input, context.clock(), context.settings(),
        new WholeSeries(input, Runnable::run));
    engine.tick(System.nanoTime());
    input.put(Robots.ODOM, Robots.odometry(0.25, 0), System.nanoTime(), Optional.empty());
    Exporter exporter = new Exporter(Runnable::run);
    PlotScene scene = engine.tick(System.nanoTime());
    exporter.export(scene, scene.extent().orElseThrow(), file.toString());
    List<String> lines = Files.readAllLines(file);
    assertEquals("time [s]," + SPEED + " [m/s]", lines.getFirst());
    assertTrue(lines.get(1).endsWith(",0.25"), lines.get(1));
    assertTrue(exporter.notice(System.nanoTime()).orElseThrow().text().startsWith("saved 1 rows"));
    exporter.export(scene, scene.extent().orElseThrow(), folder.resolve("no/such/folder.csv").toString());
    assertFalse(exporter.notice(System.nanoTime()).orElseThrow().good());
  }

  private void plot(String... signals) {
    Robots.drive(input);
    context.settings().set(PlotOptions.WINDOW, 20.0);
    context.settings().set(PlotOptions.AXES, List.of(Map.of("traces", List.of(signals))));
    step();
    pixels();
  }

  private PlotSpec spec() {
    return PlotCodec.read(context.settings().current());
  }

  private ViewAction action(String id) {
    return uic.actions().stream().filter(a -> a.id().equals(id)).findFirst().orElseThrow();
  }

  private void step() {
    uic.tick(System.nanoTime());
    uic.refresh();
    settle();
  }

  private void mouse(int type, int x, int y, int button, int state) {
    Event event = new Event();
    event.x = x;
    event.y = y;
    event.button = button;
    event.stateMask = state;
    canvas().notifyListeners(type, event);
    settle();
  }

  private void wheel(int count, int state) {
    Event event = new Event();
    event.x = X;
    event.y = Y;
    event.count = count;
    event.stateMask = state;
    canvas().notifyListeners(SWT.MouseVerticalWheel, event);
  }

  private void keys(Control control, int... codes) {
    for (int code : codes) {
      Event event = new Event();
      event.keyCode = code;
      control.notifyListeners(SWT.KeyDown, event);
    }
    settle();
  }

  private Composite root() {
    return (Composite) shell.getChildren()[0];
  }

  private PaintedCanvas canvas() {
    return find(root(), PaintedCanvas.class);
  }

  private Composite panel() {
    return (Composite) Arrays.stream(root().getChildren()).filter(Predicate.not(PaintedCanvas.class::isInstance))
        .findFirst().orElseThrow();
  }

  private static <T> T find(Composite within, Class<T> type) {
    return all(within).filter(type::isInstance).map(type::cast).findFirst().orElseThrow();
  }

  private static Stream<Control> all(Composite within) {
    return Arrays.stream(within.getChildren())
        .flatMap(c -> c instanceof Composite inner ? Stream.concat(Stream.of(c), all(inner)) : Stream.of(c));
  }

  /** The pixels of the view as it is painted now. */
  private int[] pixels() {
    Image image = new Image(display, WIDTH, HEIGHT);
    GC gc = new GC(image);
    canvas().print(gc);
    gc.dispose();
    ImageData data = image.getImageData(100);
    image.dispose();
    int[] all = new int[data.width * data.height];
    for (int i = 0; i < all.length; i++) {
      all[i] = rgb(data.palette.getRGB(data.getPixel(i % data.width, i / data.width)));
    }
    return all;
  }

  private boolean shows(RGB color) {
    return Arrays.stream(pixels()).anyMatch(p -> p == rgb(color));
  }

  private static int rgb(RGB color) {
    return color.red << 16 | color.green << 8 | color.blue;
  }

  private void settle() {
    boolean more = true;
    while (more) {
      more = display.readAndDispatch();
    }
  }
}
