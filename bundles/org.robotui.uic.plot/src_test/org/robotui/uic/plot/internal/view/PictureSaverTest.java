package org.robotui.uic.plot.internal.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Canvas;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.port.InputState;
import org.robotui.api.time.PointedTime;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.uic.plot.internal.model.AxisSpec;
import org.robotui.uic.plot.internal.model.CurveView;
import org.robotui.uic.plot.internal.model.LineStyle;
import org.robotui.uic.plot.internal.model.PlotScene;
import org.robotui.uic.plot.internal.model.PlotSpec;
import org.robotui.uic.plot.internal.model.TraceSpec;
import org.robotui.uic.plot.internal.model.TraceView;
import org.robotui.uic.plot.internal.trace.Curve;
import org.robotui.uic.plot.internal.trace.Series;
import org.robotui.uic.plot.internal.trace.TimeSpan;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class PictureSaverTest {
  private static final int WIDTH = 700;
  private static final int HEIGHT = 300;
  private static final int SAMPLES = 300;
  private static final int BREAK = 100;
  private static final String NAME = "speed <of> \"A & B\"";

  @TempDir
  private Path folder;

  private final Exporter exporter = new Exporter(Runnable::run);
  private final PlotState state = new PlotState(new PointedTime());
  private Theme theme;
  private Shell shell;
  private Canvas canvas;
  private PlotPainter painter;

  @BeforeEach
  void open() {
    Display display = TestDisplay.get();
    theme = Themes.light(display);
    shell = new Shell(display, SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setBounds(0, 0, WIDTH, HEIGHT);
    canvas = new Canvas(shell, SWT.NONE);
    painter = new PlotPainter(theme, ZoneOffset.UTC);
    shell.open();
    shell.layout();
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void asSvgEachTraceIsALineThatIsBrokenWhereItsValuesAre() throws Exception {
    for (LineStyle style : LineStyle.values()) {
      Document svg = svg(scene(style));
      List<String> lines = attributes(svg, "path", "d");
      assertEquals(1, lines.size());
      long begins = lines.getFirst().chars().filter(c -> c == 'M').count();
      assertEquals(style == LineStyle.DOTS ? SAMPLES - 1 : 2, begins, style::word);
      assertEquals(style == LineStyle.STEP, lines.getFirst().contains("V"), style::word);
    }
  }

  @Test
  void asSvgACurveHasFiguresBelowItAndScalesThatAreEqual() throws Exception {
    Document svg = svg(circle());
    assertEquals(1, attributes(svg, "path", "d").size());
    assertTrue(texts(svg).contains("pose.translation.x [m]"), () -> texts(svg).toString());
    AxisFrame frame = painter.frames().getFirst();
    Curve.Fineness fineness = frame.fineness(false);
    assertEquals(fineness.x(), fineness.y(), 1e-9);
    Point right = new Point(Math.round(frame.across(1)), Math.round(frame.y(0, false)));
    assertEquals(Optional.of(0L), painter.timeAt(frame, right).map(t -> t / TimeSpan.SECOND));
    assertEquals(Optional.empty(), painter.timeAt(frame, new Point(Math.round(frame.across(0)), right.y)));
  }

  private static PlotScene circle() {
    Curve curve = new Curve(SAMPLES);
    for (int i = 0; i < SAMPLES; i++) {
      curve.add(i * TimeSpan.SECOND / 10, Math.cos(i * 0.02), Math.sin(i * 0.02));
    }
    TraceSpec spec = TraceSpec.of("base.odom:pose.translation.y");
    TraceView trace = new TraceView(spec, 0, NAME, "base", "m", Optional.of(curve.y()), new InputState.Live(10, 0),
        Optional.empty(), List.of(), 0, Optional.empty(),
        Optional.of(new CurveView(curve, "base.odom:pose.translation.x", "pose.translation.x", "m")));
    AxisSpec axis = AxisSpec.EMPTY.with(List.of(spec)).over(Optional.of("base.odom:pose.translation.x"));
    return new PlotScene(
        new PlotSpec(List.of(axis), 0, true, true, LineStyle.LINE, PlotSpec.LegendPlace.SIDE), List.of(List.of(trace)),
        (SAMPLES - 1) * TimeSpan.SECOND / 10);
  }

  @Test
  void asSvgNamesUnitsAndFiguresAreText() throws Exception {
    List<String> words = texts(svg(scene(LineStyle.LINE)));
    assertTrue(words.contains(NAME) && words.contains("m/s") && words.contains("0.5"), words::toString);
  }

  @Test
  void asPngItHasTwiceThePixelsAndNothingOfThePointer() {
    PlotScene scene = scene(LineStyle.LINE);
    paint(scene);
    save(scene, "without.png");
    state.pointer(Optional.of(new Point(WIDTH / 3, HEIGHT / 2)));
    save(scene, "with.png");
    ImageData without = new ImageData(folder.resolve("without.png").toString());
    assertEquals(2 * canvas.getClientArea().width, without.width);
    assertTrue(count(without, theme.palette().traces().getFirst()) > SAMPLES, "its line");
    ImageData with = new ImageData(folder.resolve("with.png").toString());
    assertEquals(count(without, theme.palette().traces().getFirst()), count(with, theme.palette().traces().getFirst()));
    assertTrue(state.pointer().isPresent(), "the view goes on with it");
  }

  @Test
  void whatCannotBeWrittenIsSaid() {
    PlotScene scene = scene(LineStyle.LINE);
    paint(scene);
    save(scene, "no/such/folder.svg");
    assertFalse(exporter.notice(System.nanoTime()).orElseThrow().good());
  }

  private static List<String> texts(Document svg) {
    NodeList texts = svg.getElementsByTagName("text");
    return IntStream.range(0, texts.getLength()).mapToObj(i -> texts.item(i).getTextContent()).toList();
  }

  private Document svg(PlotScene scene) throws Exception {
    paint(scene);
    save(scene, "plot.svg");
    byte[] text = Files.readString(folder.resolve("plot.svg")).getBytes(StandardCharsets.UTF_8);
    return DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(new ByteArrayInputStream(text));
  }

  private void save(PlotScene scene, String name) {
    new PictureSaver(theme, painter, exporter).save(canvas, scene, state, folder.resolve(name));
  }

  private void paint(PlotScene scene) {
    Image image = new Image(canvas.getDisplay(), WIDTH, HEIGHT);
    GC gc = new GC(image);
    painter.paint(gc, canvas.getClientArea(), scene, state);
    gc.dispose();
    image.dispose();
  }

  private static List<String> attributes(Document svg, String element, String name) {
    NodeList all = svg.getElementsByTagName(element);
    return IntStream.range(0, all.getLength()).mapToObj(i -> ((Element) all.item(i)).getAttribute(name)).toList();
  }

  private static int count(ImageData picture, RGB color) {
    int count = 0;
    for (int y = 0; y < picture.height; y++) {
      for (int x = 0; x < picture.width; x++) {
        count += picture.palette.getRGB(picture.getPixel(x, y)).equals(color) ? 1 : 0;
      }
    }
    return count;
  }

  private static PlotScene scene(LineStyle style) {
    Series series = new Series(SAMPLES);
    for (int i = 0; i < SAMPLES; i++) {
      series.add(i * TimeSpan.SECOND / 10, i == BREAK ? Double.NaN : Math.sin(i * 0.1));
    }
    TraceSpec spec = new TraceSpec("base.odom:linear.x", Optional.of(NAME), Optional.empty(), OptionalInt.empty(),
        Optional.empty(), false, false);
    TraceView trace = new TraceView(spec, 0, NAME, "base", "m/s", Optional.of(series), new InputState.Live(10, 0),
        Optional.empty(), List.of(), 0);
    AxisSpec axis = new AxisSpec(List.of(spec), AxisSpec.EMPTY.left(), AxisSpec.EMPTY.right());
    return new PlotScene(new PlotSpec(List.of(axis), 0, true, true, style, PlotSpec.LegendPlace.SIDE),
        List.of(List.of(trace)), (SAMPLES - 1) * TimeSpan.SECOND / 10);
  }
}
