package org.robotui.uic.scene3d.hostile;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.data.Data;
import org.robotui.entity.bumper.internal.display.BumperType;
import org.robotui.entity.gridmap.internal.display.GridMapType;
import org.robotui.entity.image.internal.display.CameraType;
import org.robotui.entity.image.internal.display.ImageType;
import org.robotui.entity.laserscan.internal.display.LaserScanType;
import org.robotui.entity.marker.internal.InteractiveType;
import org.robotui.entity.marker.internal.MarkersType;
import org.robotui.entity.odometry.internal.display.GoalType;
import org.robotui.entity.odometry.internal.display.OdometryType;
import org.robotui.entity.odometry.internal.display.PoseEstimateType;
import org.robotui.entity.odometry.internal.display.StampedPoseType;
import org.robotui.entity.path.internal.display.PathType;
import org.robotui.entity.path.internal.display.PoseArrayType;
import org.robotui.entity.pointcloud.internal.PointCloudType;
import org.robotui.entity.robotmodel.internal.ModelShelf;
import org.robotui.entity.robotmodel.internal.RobotModelType;
import org.robotui.entity.robotmodel.internal.TrajectoryType;
import org.robotui.entity.sonar.internal.display.SonarType;
import org.robotui.entity.wrench.internal.display.WrenchType;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayType;
import org.robotui.gl.render.Rendered;
import org.robotui.gl.shape.Part;
import org.robotui.testkit.Displays;
import org.robotui.testkit.Effort;
import org.robotui.testkit.ScenePictures;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.values.Spoiler;
import org.robotui.testkit.values.ValidValues;

/**
 * Whatever a robot sends, displays show it, or say what is wrong with it; they neither throw nor take much memory, and
 * what they show can be drawn.
 */
class HostileDataTest {
  private static final List<DisplayType> TYPES =
      List.of(new LaserScanType(), new PointCloudType(), new GridMapType(), new OdometryType(),
          new PoseEstimateType(), new StampedPoseType(), new GoalType(), new PathType(), new PoseArrayType(),
          new MarkersType(), new InteractiveType(),
          new ImageType(), new CameraType(), new SonarType(), new BumperType(), new WrenchType(),
          new RobotModelType(new ModelShelf()), new TrajectoryType(new ModelShelf()));
  private static final int ROUNDS = 250;
  private static final int CHANGES = 4;
  /** A hundred times of what the sound data need, and lists of twenty thousand. */
  private static final long MOST_BYTES = 100 << 20;
  private static final int DRAWN_EVERY = 25;

  static Stream<DisplayType> types() {
    return TYPES.stream();
  }

  private static List<Data> sound(DisplayType type) {
    return ValidValues.all().stream()
        .filter(value -> type.accepts().stream().anyMatch(accepted -> accepted.isInstance(value))).toList();
  }

  @ParameterizedTest
  @MethodSource("types")
  void soundDataAreShown(DisplayType type) {
    List<Data> data = sound(type);
    assertFalse(data.isEmpty(), type.id());
    try (DisplayProbe probe = new DisplayProbe(type)) {
      probe.places().knowAll();
      probe.tick(data.toArray(Data[]::new));
      assertFalse(probe.tick().parts().isEmpty(), type.id());
    }
  }

  @ParameterizedTest
  @MethodSource("types")
  @Timeout(600)
  void spoiledDataAreShownOrRefusedInWords(DisplayType type) {
    Spoiler spoiler = new Spoiler(type.id().hashCode());
    List<Data> sound = sound(type);
    DisplayProbe probe = open(type);
    int said = 0;
    int round = 0;
    for (Effort effort = Effort.of(ROUNDS, Duration.ofSeconds(30)); effort.goesOn(); round++) {
      List<Data> spoiled = sound.stream().map(value -> spoil(spoiler, value)).toList();
      DisplayResult result = show(probe, type, spoiled);
      said += result.status().words().isBlank() ? 0 : 1;
      if (round % 10 == 9) {
        probe.close();
        probe = open(type);
      }
    }
    probe.close();
    assertTrue(said > 0, "nothing was said");
  }

  private static DisplayProbe open(DisplayType type) {
    DisplayProbe probe = new DisplayProbe(type);
    probe.places().knowAll();
    return probe;
  }

  private static Data spoil(Spoiler spoiler, Data value) {
    Data spoiled = value;
    for (int i = 0; i < CHANGES; i++) {
      spoiled = spoiler.spoil(spoiled);
    }
    return spoiled;
  }

  private static DisplayResult show(DisplayProbe probe, DisplayType type, List<Data> data) {
    try {
      probe.tick(data.toArray(Data[]::new));
      DisplayResult result = probe.tick();
      Set<Object> keys = new HashSet<>();
      result.parts().forEach(part -> assertTrue(keys.add(part.key()), () -> "two parts have the key " + part.key()));
      long bytes = result.parts().stream().mapToLong(part -> part.shape().bytes()).sum();
      assertTrue(bytes < MOST_BYTES, () -> bytes + " bytes");
      result.parts().stream().limit(50).forEach(part -> part.describer().describe(0, Vector3.ZERO));
      return result;
    } catch (RuntimeException | AssertionError e) {
      String words = data.toString();
      throw new AssertionError(type.id() + ": " + words.substring(0, Math.min(3000, words.length())), e);
    }
  }

  @Test
  @Timeout(600)
  @EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
  void whatBecomesOfSpoiledDataCanBeDrawn() {
    try (ScenePictures pictures = new ScenePictures()) {
      for (DisplayType type : TYPES) {
        Spoiler spoiler = new Spoiler(type.id().hashCode() + 1);
        List<Data> sound = sound(type);
        for (int round = 0; round < ROUNDS / DRAWN_EVERY; round++) {
          try (DisplayProbe probe = open(type)) {
            List<Part> parts = show(probe, type, sound.stream().map(value -> spoil(spoiler, value)).toList()).parts();
            Rendered made =
                pictures.render(ScenePictures.request(parts, ScenePictures.eye(new Vector3(-3, -2, 3), Vector3.ZERO)));
            assertTrue(made instanceof Rendered.Picture, () -> type.id() + ": " + made);
          }
        }
      }
    }
  }
}
