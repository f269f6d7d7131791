package org.robotui.entity.gridmap.internal.display;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.data.navigation.GridMap;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.recorded.SharedData;

/** Maps of real and simulated rooms. */
@EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
class SharedMapsTest {
  /** Cells that are occupied, free and unknown, as the page of the data says. */
  private static final Map<String, List<Integer>> CELLS = Map.of("sena_loop.yaml", List.of(4189, 141099, 321479),
      "depot.yaml", List.of(5947, 179481, 0), "tb3_sandbox.yaml", List.of(870, 7903, 138683), "testmap.yaml",
      List.of(29, 71, 0));

  static List<Path> maps() {
    return SharedData.files("maps", ".yaml");
  }

  @ParameterizedTest
  @MethodSource("maps")
  void everyMapIsDrawn(Path file) throws IOException {
    GridMap map = MapFile.read(file);
    assertEquals(CELLS.get(file.getFileName().toString()),
        List.of(count(map, 100), count(map, 0), count(map, GridMap.UNKNOWN)));
    try (DisplayProbe probe = new DisplayProbe(new GridMapType())) {
      DisplayResult result = probe.tick(map);
      assertInstanceOf(DisplayStatus.Shown.class, result.status());
      if (Displays.available()) {
        try (ScenePictures pictures = new ScenePictures()) {
          pictures.assertSeen(file.toString(), result.parts());
        }
      }
    }
  }

  private static int count(GridMap map, int value) {
    int count = 0;
    for (int i = 0; i < map.cells().size(); i++) {
      count += map.cells().get(i) == value ? 1 : 0;
    }
    return count;
  }
}
