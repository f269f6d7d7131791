package org.robotui.entity.robotmodel.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.RobotDescription;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;
import org.robotui.testkit.recorded.SharedData;

/** Models of real robots, from their text to what is seen. */
@EnabledIf(value = SharedData.AVAILABLE, disabledReason = SharedData.REASON)
class SharedModelsTest {
  /** How many links there are, and what the one model lacks, as the page of the data says. */
  private static final Map<String, String> SAID =
      Map.of("panda.urdf", "13 links", "panda_collision.urdf", "13 links", "husky.urdf", "15 links",
          "coman.urdf", "the material 'dark_gray' is defined nowhere");

  static List<Path> models() {
    return SharedData.files("robots", ".urdf");
  }

  private static DisplayResult show(Path file, List<String> folders) throws IOException {
    Bench bench = new Bench();
    bench.settings.set(RobotModelType.COLLISION, true);
    return bench.give(new RobotDescription(Bench.ROBOT, file.toString(), Files.readString(file), "", folders))
        .give(new JointState(List.of())).settled();
  }

  @ParameterizedTest
  @MethodSource("models")
  void everyModelIsDrawnWithItsMeshes(Path file) throws IOException {
    DisplayResult result = show(file, List.of(SharedData.file("robots").toString()));
    assertTrue(result.status().words().contains(SAID.get(file.getFileName().toString())), result.status().words());
    if (Displays.available()) {
      try (ScenePictures pictures = new ScenePictures()) {
        pictures.assertSeen(file.toString(), result.parts());
      }
    }
  }

  @ParameterizedTest
  @MethodSource("models")
  void meshesThatAreAbsentAreNamed(Path file) throws IOException {
    DisplayResult result = show(file, List.of());
    DisplayStatus.Partly partly = assertInstanceOf(DisplayStatus.Partly.class, result.status());
    String name = SharedData.file("robots").relativize(file).getName(0).toString();
    assertTrue(partly.words().contains("'" + name + "'"), partly.words());
    assertEquals(0, result.dropped());
  }
}
