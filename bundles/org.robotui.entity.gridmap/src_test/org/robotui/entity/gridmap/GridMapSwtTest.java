package org.robotui.entity.gridmap;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.widgets.Display;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.navigation.GridMap;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.scene.Painter;
import org.robotui.ui.scene.Viewport;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class GridMapSwtTest {
  private static final FrameId FRAME = new FrameId("Keira", "map");
  private static final int WIDTH = 400;
  private static final int HEIGHT = 300;

  private final Display display = TestDisplay.get();
  private Theme theme;
  private Image image;

  @BeforeEach
  void open() {
    theme = Themes.dark(display);
    image = new Image(display, WIDTH, HEIGHT);
  }

  @AfterEach
  void close() {
    image.dispose();
    theme.dispose();
  }

  @Test
  void wallsOfATurnedMapArePaintedWhereTheyLie() {
    byte[] cells = new byte[40 * 20];
    Arrays.fill(cells, GridMap.UNKNOWN);
    cells[15 * 40 + 30] = 100;
    RigidTransform origin = RigidTransform.planar(-2, -1, 1);
    GridMapEntity entity = new GridMapEntity();
    entity.prepare(new GridMap(FRAME, 0.1, 40, 20, origin, Bytes.of(cells)), RigidTransform.IDENTITY);
    Viewport viewport = new Viewport(0, 0, 45, WIDTH, HEIGHT);
    ImageData picture = paint(entity, viewport);
    Vector3 wall = origin.apply(new Vector3(3.05, 1.55, 0));
    assertEquals(theme.palette().rgb(Role.WALL), pixel(picture, viewport, wall.x(), wall.y()));
    Vector3 beside = origin.apply(new Vector3(3.25, 1.55, 0));
    assertEquals(theme.palette().rgb(Role.PANEL), pixel(picture, viewport, beside.x(), beside.y()));
  }

  @Test
  void tilesMeetWithoutASeam() {
    byte[] cells = new byte[600 * 300];
    Arrays.fill(cells, (byte) 100);
    GridMapEntity entity = new GridMapEntity();
    entity.prepare(new GridMap(FRAME, 0.05, 600, 300, RigidTransform.planar(-15, -7.5, 0), Bytes.of(cells)),
        RigidTransform.IDENTITY);
    Viewport viewport = new Viewport(-2.2, 0.013, 23.7, WIDTH, HEIGHT);
    ImageData picture = paint(entity, viewport);
    for (int x = 0; x < WIDTH; x++) {
      assertEquals(theme.palette().rgb(Role.WALL), picture.palette.getRGB(picture.getPixel(x, HEIGHT / 2)), "x " + x);
    }
  }

  @Test
  void aHugeMapIsPaintedInPartsAndThenQuickly() {
    int edge = 4000;
    GridMapEntity entity = new GridMapEntity();
    entity.prepare(new GridMap(FRAME, 0.05, edge, edge, RigidTransform.IDENTITY, Bytes.of(new byte[edge * edge])),
        RigidTransform.IDENTITY);
    Viewport all = new Viewport(100, 100, 1.4, WIDTH, HEIGHT);
    Viewport near = new Viewport(80, 120, 25, WIDTH, HEIGHT);
    paint(entity, all);
    paint(entity, near);
    double[] millis = new double[15];
    for (int i = 0; i < millis.length; i++) {
      long start = System.nanoTime();
      paint(entity, i % 2 == 0 ? all : near);
      millis[i] = (System.nanoTime() - start) * 1e-6;
    }
    Arrays.sort(millis);
    assertTrue(millis[3] < 25, () -> "painting takes " + Arrays.toString(millis) + " ms");
    entity.dispose();
  }

  @Test
  void nothingOfTheDisplayIsLeftAfterDisposal() {
    GridMapEntity entity = new GridMapEntity();
    entity.prepare(new GridMap(FRAME, 0.05, 900, 900, RigidTransform.IDENTITY, Bytes.of(new byte[900 * 900])),
        RigidTransform.IDENTITY);
    int before = display.getDeviceData().objects.length;
    paint(entity, new Viewport(20, 20, 20, WIDTH, HEIGHT));
    assertTrue(display.getDeviceData().objects.length > before, "tiles are kept");
    entity.dispose();
    assertEquals(before, display.getDeviceData().objects.length);
  }

  private ImageData paint(GridMapEntity entity, Viewport viewport) {
    boolean again = true;
    for (int i = 0; again && i < 500; i++) {
      GC gc = new GC(image);
      gc.setBackground(theme.color(Role.PANEL));
      gc.fillRectangle(0, 0, WIDTH, HEIGHT);
      Painter painter = new Painter(gc, viewport, theme);
      entity.paint(painter);
      again = painter.wantsAgain();
      gc.dispose();
    }
    assertFalse(again, "the map never gets complete");
    return image.getImageData();
  }

  private static RGB pixel(ImageData picture, Viewport viewport, double x, double y) {
    return picture.palette.getRGB(picture.getPixel((int) viewport.pixelX(x), (int) viewport.pixelY(y)));
  }
}
