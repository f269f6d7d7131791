package org.robotui.uic.scene3d.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Predicate;
import org.eclipse.swt.widgets.Display;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.port.Input;
import org.robotui.api.port.SourceId;
import org.robotui.data.Data;
import org.robotui.data.DataType;
import org.robotui.entity.grid.internal.display.AxesType;
import org.robotui.entity.grid.internal.display.GridType;
import org.robotui.entity.gridmap.internal.display.GridMapType;
import org.robotui.entity.laserscan.internal.display.LaserScanType;
import org.robotui.entity.odometry.internal.display.OdometryType;
import org.robotui.entity.path.internal.display.PathType;
import org.robotui.entity.pointcloud.internal.PointCloudType;
import org.robotui.gl.display.DisplayType;
import org.robotui.gl.internal.gpu.Ledger.Kind;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.display.DisplayCodec;
import org.robotui.ui.display.DisplaySpec;

/** Which objects of OpenGL an open scene holds while its displays come and go, and after its context was lost. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class SceneObjectsTest {
  private static final List<DisplayType> KINDS =
      List.of(new GridType(), new AxesType(), new GridMapType(), new LaserScanType(), new PointCloudType(),
          new PathType(), new OdometryType());
  private static final List<DisplaySpec> ALL =
      KINDS.stream().map(kind -> DisplaySpec.of(kind.id(), kind.id())).toList();
  private static final int POINTS = 1000;
  private static final int ROUNDS = 200;
  private static final int LOSSES = 5;
  private static final long PATIENCE_NANOS = 20_000_000_000L;

  private final Display display = TestDisplay.get();
  private final Theme theme = Themes.dark(display);
  private final HeldGl gl = new HeldGl();
  private final AtomicLong pictures = new AtomicLong();
  private final Map<SourceId, Data> data = GalleryData.all(POINTS);
  private SceneWindow window;
  private int turns;

  @BeforeEach
  void open() {
    window = new SceneWindow(display, theme, 320, 200, KINDS, () -> Optional.of(new CountedGl(gl, pictures)));
    window.context.settings().set(SceneOptions.AUTOMATIC, false);
    GalleryData.frames(window.frames);
    window.context.input(ScenePorts.DATA).candidates(
        data.entrySet().stream().map(e -> new Input.Candidate(e.getKey(), DataType.of(e.getValue().getClass()).name()))
            .toList());
  }

  @AfterEach
  void close() {
    window.close();
    assertEquals(Map.of(), gl.held(), "after the scene was closed");
    gl.close();
    theme.dispose();
  }

  /**
   * Shows some displays, with data that have just come; what is held when they are drawn, as soon as that is as wanted.
   */
  private Map<Kind, Integer> show(List<DisplaySpec> displays, Predicate<Map<Kind, Integer>> wanted) {
    window.context.settings().set(SceneOptions.DISPLAYS, DisplayCodec.write(displays));
    window.tick();
    data.forEach((source, value) -> window.context.input(ScenePorts.DATA).put(source, value, System.nanoTime(),
        Optional.empty()));
    window.tick();
    awaitPicture();
    long deadline = System.nanoTime() + PATIENCE_NANOS;
    Map<Kind, Integer> held;
    do {
      window.tick();
      awaitPicture();
      held = gl.held();
    } while (!wanted.test(held) && System.nanoTime() < deadline);
    return held;
  }

  /** One that was asked for from now on: the camera does not come back to where a picture was made before. */
  private void awaitPicture() {
    long before = pictures.get();
    turns++;
    window.hands().wheel(turns % 2 == 0 ? 1 : -1, 240 + turns * 5 % 17, 100);
    assertTrue(window.until(() -> pictures.get() > before), "no picture came");
  }

  /** All displays: once the map has its texture, the picture is of the data that have come. */
  private Map<Kind, Integer> showAll() {
    int before = show(List.of(), held -> held.getOrDefault(Kind.TEXTURE, 0) <= 3).getOrDefault(Kind.TEXTURE, 0);
    return show(ALL, held -> held.get(Kind.TEXTURE) > before);
  }

  @Test
  void displaysThatAreRemovedLeaveNothing() {
    showAll();
    Map<Kind, Integer> empty = show(List.of(), held -> !held.containsKey(Kind.BUFFER));
    Map<Kind, Integer> full = showAll();
    for (int round = 0; round < ROUNDS; round++) {
      List<DisplaySpec> some = new ArrayList<>(ALL);
      some.remove(round % ALL.size());
      show(some, held -> true);
      assertEquals(full, show(ALL, full::equals), "all displays, in round " + round);
    }
    assertEquals(empty, show(List.of(), empty::equals), "no displays");
  }

  @Test
  void aLostContextIsMadeAnewWithAsManyObjects() {
    Map<Kind, Integer> full = showAll();
    for (int loss = 0; loss < LOSSES; loss++) {
      gl.lose();
      assertEquals(Map.of(), gl.held(), "after the context was lost");
      assertEquals(full, show(ALL, full::equals));
    }
  }
}
