package org.robotui.ui.diagram;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Display;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.diagram.Wire.Corner;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class WireLabelsTest {
  private static final int WIDTH = 400;
  private static final int HEIGHT = 300;

  private final Display display = TestDisplay.get();
  private final Theme theme = Themes.dark(display);

  @AfterEach
  void close() {
    theme.dispose();
  }

  /** Wires across, so far apart in the diagram, each between two boxes without words. */
  private static Diagram wires(int count, double apart) {
    List<Box> boxes = IntStream.range(0, 2 * count)
        .mapToObj(
            i -> new Box(i, i % 2 * 390.0, i / 2 * apart, 10, 10, Box.Form.ROUNDED, "", "", Health.NONE, Role.LINE))
        .toList();
    List<Wire> wires = IntStream.range(0, count).mapToObj(i -> new Wire(2 * i, 2 * i + 1,
        List.of(new Corner(10, i * apart + 5), new Corner(390, i * apart + 5)), "HH", Role.DIM, false)).toList();
    return new Diagram(boxes, wires, 400, count * apart);
  }

  /** Rows in which letters are seen. */
  private List<Integer> rows(Diagram diagram, double zoom, Optional<Object> selected) {
    DiagramEye eye = new DiagramEye();
    eye.zoom(0, 0, zoom);
    Image image = new Image(display, WIDTH, HEIGHT);
    GC gc = new GC(image);
    gc.setBackground(theme.color(Role.PANEL));
    gc.fillRectangle(0, 0, WIDTH, HEIGHT);
    new DiagramPainter(theme).paint(gc, new Rectangle(0, 0, WIDTH, HEIGHT), diagram, eye, selected, Set.of());
    gc.dispose();
    ImageData data = image.getImageData();
    image.dispose();
    int middle = (int) (200 * zoom);
    return IntStream.range(0, HEIGHT)
        .filter(y -> IntStream.range(middle - 15, middle + 15).anyMatch(x -> isLetter(data, x, y))).boxed().toList();
  }

  private boolean isLetter(ImageData data, int x, int y) {
    RGB seen = data.palette.getRGB(data.getPixel(x, y));
    RGB letters = theme.palette().rgb(Role.TEXT);
    return Math.abs(seen.red - letters.red) + Math.abs(seen.green - letters.green)
        + Math.abs(seen.blue - letters.blue) < 120;
  }

  @Test
  void aLabelIsReadAlsoWhereBoxesAreSmall() {
    int whole = rows(wires(1, 100), 1, Optional.empty()).size();
    assertTrue(whole >= 6, whole + " rows");
    for (double zoom : new double[]{0.6, 0.4, 0.25}) {
      int rows = rows(wires(1, 100), zoom, Optional.empty()).size();
      assertTrue(rows >= whole - 3, () -> rows + " rows at " + zoom + ", " + whole + " at 1");
    }
    assertEquals(List.of(), rows(wires(1, 100), 0.1, Optional.empty()));
  }

  @Test
  void labelsDoNotCoverEachOther() {
    int one = rows(wires(1, 100), 0.3, Optional.empty()).size();
    assertEquals(one, rows(wires(2, 20), 0.3, Optional.empty()).size(), "the second would lie on the first");
    assertEquals(2 * one, rows(wires(2, 200), 0.3, Optional.empty()).size(), 2);
    List<Integer> chosen = rows(wires(2, 20), 0.3, Optional.of(2));
    assertTrue(chosen.getFirst() > rows(wires(1, 100), 0.3, Optional.empty()).getFirst(),
        "that of the selected one goes first");
  }
}
