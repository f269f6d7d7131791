package org.robotui.ui.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Palette;
import org.robotui.ui.Role;
import org.robotui.ui.TextFit;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class ControlLookSwtTest {
  private static final int WIDTH = 200;
  private static final int HEIGHT = 26;
  private static final Column<String> NAME = Column.<String>words("Name", s -> s).dot(s -> Health.OK);

  private final Display display = TestDisplay.get();
  private final Shell shell = new Shell(display);
  private Theme theme = Themes.dark(display);

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @ParameterizedTest
  @ValueSource(strings = {Themes.DARK, Themes.LIGHT})
  void whatWasSearchedIsMarkedAndLegible(String id) {
    theme.dispose();
    theme = Themes.of(display, id);
    CellPainter cells = new CellPainter(theme);
    ImageData plain = painted(gc -> cells.cell(gc, cell(), NAME, "camera info"));
    cells.search("INFO");
    ImageData marked = painted(gc -> cells.cell(gc, cell(), NAME, "camera info"));
    RGB found = theme.mix(Role.WARNING, Role.PANEL, 0.38).getRGB();
    assertEquals(0, count(plain, found));
    assertTrue(count(marked, found) > 100);
    assertTrue(Palette.contrast(theme.color(Role.TEXT).getRGB(), found) > 4.5, "contrast of marked words");
  }

  @Test
  void wordsStayWithinTheirCell() {
    CellPainter cells = new CellPainter(theme);
    Rectangle narrow = new Rectangle(50, 0, 90, HEIGHT);
    ImageData data = painted(gc -> cells.cell(gc, narrow, NAME, "a name that is much too long for its cell"));
    RGB ground = theme.color(Role.PANEL).getRGB();
    for (int y = 0; y < HEIGHT; y++) {
      for (int x = 0; x < WIDTH; x++) {
        boolean inside = x >= narrow.x && x < narrow.x + narrow.width;
        assertTrue(inside || data.palette.getRGB(data.getPixel(x, y)).equals(ground), "painted at " + x + ", " + y);
      }
    }
  }

  @Test
  void figuresEndAtTheSameEdge() {
    CellPainter cells = new CellPainter(theme);
    Column<String> figures = Column.figures("Rate", s -> s);
    assertEquals(lastInk(painted(gc -> cells.cell(gc, cell(), figures, "100.0 Hz"))),
        lastInk(painted(gc -> cells.cell(gc, cell(), figures, "1.0 Hz"))), 1);
  }

  @Test
  void anIconStaysWhereItIsWhenTheTextBesideItIsCut() {
    int content = 100;
    assertEquals(QuietButton.start(content + 2 * Theme.EDGE, content, true),
        QuietButton.start(content - 1, content, true));
    assertEquals(Theme.STEP, QuietButton.start(content - 1, content, false),
        "without an icon all of the room is the text's");
  }

  @Test
  void aPathKeepsItsEnd() {
    GC gc = new GC(display);
    gc.setFont(theme.font(Face.BODY));
    String path = "robot/arm/joints[3].effort.of.the.motor";
    String shown = TextFit.shortenFront(gc, path, 120);
    String more = path.substring(path.length() - shown.length());
    int width = gc.textExtent(shown).x;
    int wider = gc.textExtent("\u2026" + more).x;
    String all = TextFit.shortenFront(gc, path, 1000);
    String none = TextFit.shortenFront(gc, path, 1);
    gc.dispose();
    assertTrue(shown.startsWith("\u2026") && path.endsWith(shown.substring(1)), shown);
    assertTrue(width <= 120 && wider > 120, shown);
    assertEquals(path, all);
    assertEquals("", none);
  }

  @Test
  void aTextOfMegabytesIsCutQuickly() {
    String text = "x".repeat(5_000_000);
    GC gc = new GC(display);
    gc.setFont(theme.font(Face.BODY));
    long start = System.nanoTime();
    String shown = TextFit.shorten(gc, text, WIDTH);
    double millis = (System.nanoTime() - start) / 1e6;
    int width = gc.textExtent(shown).x;
    gc.dispose();
    assertTrue(shown.endsWith("\u2026") && width <= WIDTH && width > WIDTH - 20, width + " of " + WIDTH);
    assertTrue(millis < 1000, millis + " ms");
  }

  @Test
  void aKnownTextFitsAnewWhereThereIsLessRoom() {
    FittedTexts texts = new FittedTexts();
    GC gc = new GC(display);
    gc.setFont(theme.font(Face.BODY));
    FittedTexts.Fitted wide = texts.fit(gc, Face.BODY, "/camera/image_raw", WIDTH);
    FittedTexts.Fitted narrow = texts.fit(gc, Face.BODY, "/camera/image_raw", WIDTH / 4);
    FittedTexts.Fitted again = texts.fit(gc, Face.BODY, "/camera/image_raw", WIDTH);
    gc.dispose();
    assertEquals("/camera/image_raw", wide.shown());
    assertTrue(narrow.shown().endsWith("\u2026") && narrow.size().x <= WIDTH / 4);
    assertEquals(wide, again);
  }

  @Test
  void aFilterFieldTellsClearsAndGoesOn() {
    List<String> told = new ArrayList<>();
    shell.setLayout(new FillLayout());
    FilterField field = new FilterField(shell, theme, "Filter", told::add).onDown(() -> told.add("down"));
    Control text = Arrays.stream(field.getChildren()).filter(Text.class::isInstance).findFirst().orElseThrow();
    QuietButton clear = (QuietButton) Arrays.stream(field.getChildren()).filter(QuietButton.class::isInstance)
        .findFirst().orElseThrow();
    shell.open();
    assertFalse(clear.getVisible());
    field.words("scan");
    assertTrue(clear.getVisible());
    clear.press();
    field.words("odom");
    text.notifyListeners(SWT.KeyDown, key(SWT.ARROW_DOWN));
    text.notifyListeners(SWT.KeyDown, key(SWT.ESC));
    assertEquals(List.of("scan", "", "odom", "down", ""), told);
  }

  @Test
  void controlsLeaveNothingBehind() {
    openAndClose(); // the theme keeps what was used once
    int before = display.getDeviceData().objects.length;
    openAndClose();
    assertEquals(before, display.getDeviceData().objects.length);
  }

  private void openAndClose() {
    Shell other = new Shell(display);
    RowTable<String> table = new RowTable<>(other, theme, List.of(NAME), s -> s);
    table.list().named("Names").drag(Optional::of);
    table.show(List.of("a", "b"));
    new RecordTree(other, theme).show(Records.scan(10, 0));
    new RecordForm(other, theme).shape(Shapes.TASK);
    new FilterField(other, theme, "Filter", words -> {});
    other.dispose();
  }

  private static Event key(int code) {
    Event event = new Event();
    event.keyCode = code;
    return event;
  }

  private static Rectangle cell() {
    return new Rectangle(0, 0, WIDTH, HEIGHT);
  }

  private ImageData painted(Consumer<GC> painting) {
    Image image = new Image(display, WIDTH, HEIGHT);
    GC gc = new GC(image);
    gc.setBackground(theme.color(Role.PANEL));
    gc.fillRectangle(0, 0, WIDTH, HEIGHT);
    painting.accept(gc);
    gc.dispose();
    ImageData data = image.getImageData(100);
    image.dispose();
    return data;
  }

  private static int count(ImageData data, RGB color) {
    int count = 0;
    for (int y = 0; y < data.height; y++) {
      for (int x = 0; x < data.width; x++) {
        count += data.palette.getRGB(data.getPixel(x, y)).equals(color) ? 1 : 0;
      }
    }
    return count;
  }

  private int lastInk(ImageData data) {
    RGB ground = theme.color(Role.PANEL).getRGB();
    for (int x = data.width - 1; x >= 0; x--) {
      for (int y = 0; y < data.height; y++) {
        if (!data.palette.getRGB(data.getPixel(x, y)).equals(ground)) {
          return x;
        }
      }
    }
    return -1;
  }
}
