package org.robotui.rfic.line.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.data.FrameId;
import org.robotui.data.command.VelocityCommand;

class LineMessagesTest {

  @Test
  void a_pose_is_read_in_metres_and_in_frames_of_the_robot() {
    LineMessages.Pose pose = LineMessages.pose("pose 12 1500 -2000", "robby");

    assertEquals(1.5, pose.odometry().pose().translation().x());
    assertEquals(-2.0, pose.odometry().pose().translation().y());
    assertEquals(new FrameId("robby", "odom"), pose.odometry().frame());
    assertEquals(12_000_000_000L, pose.stamp().nanos());
    assertEquals(new FrameId("robby", "base"), pose.frames().transforms().getFirst().child());
  }

  @ParameterizedTest
  @ValueSource(strings = {"pose", "pose 1 2", "pose 1 2 3 4", "pose a 2 3", "pose 1 NaN 0", "pose 1 Infinity 0",
      "pose -1 0 0", "pose 1e300 0 0"})
  void what_is_no_pose_is_refused(String text) {
    assertThrows(IllegalArgumentException.class, () -> LineMessages.pose(text, "robby"));
  }

  @Test
  void a_motion_is_said_in_millimetres_and_degrees() {
    assertEquals("drive 300.0 90.0", LineMessages.drive(VelocityCommand.planar(0.3, Math.PI / 2)));
  }

  @Test
  void a_line_without_an_end_is_given_up() throws IOException {
    assertEquals(Optional.of("tick"), input("tick\n").next());
    assertEquals(Optional.empty(), input("tic").next());
    assertThrows(IOException.class, () -> input("x".repeat(300)).next());
  }

  private static LineInput input(String text) {
    return new LineInput(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
  }
}
