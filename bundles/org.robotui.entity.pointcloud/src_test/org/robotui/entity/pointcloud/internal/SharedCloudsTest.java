package org.robotui.entity.pointcloud.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.shape.Box3;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.recorded.SharedData;

/** Clouds of real sensors. */
@EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
class SharedCloudsTest {
  /** Points, and their box, as the page of the data says. */
  private record Known(int points, Vector3 low, Vector3 high) {}

  private static final Map<String, Known> KNOWN = Map.of(
      "room_scan1.pcd",
      new Known(112586, new Vector3(-13.7998, -6.4928, -1.3517), new Vector3(15.4471, 7.9796, 1.7091)),
      "region_growing_rgb_tutorial.pcd",
      new Known(640 * 480, new Vector3(-1.0721, -1.5806, 0.8430), new Vector3(1.8102, 0.4081, 3.8210)),
      "lamppost.pcd", new Known(1771, new Vector3(-11.1719, -0.3750, -5.4480), new Vector3(-9.7656, 0.5938, 0.4670)));

  static List<Path> clouds() {
    return SharedData.files("pcd", ".pcd");
  }

  @ParameterizedTest
  @MethodSource("clouds")
  void everyCloudIsDrawn(Path file) throws IOException {
    try (DisplayProbe probe = new DisplayProbe(new PointCloudType())) {
      probe.places().knowAll();
      DisplayResult result = probe.tick(PcdFile.read(file));
      assertInstanceOf(DisplayStatus.Shown.class, result.status());
      Known known = KNOWN.get(file.getFileName().toString());
      assertEquals(known.points(), result.parts().getFirst().shape().elements());
      Box3 box = result.parts().getFirst().bounds().orElseThrow();
      assertEquals(0, box.low().minus(known.low()).norm() + box.high().minus(known.high()).norm(), 2e-4);
      if (Displays.available()) {
        try (ScenePictures pictures = new ScenePictures()) {
          pictures.assertSeen(file.toString(), result.parts());
        }
      }
    }
  }
}
