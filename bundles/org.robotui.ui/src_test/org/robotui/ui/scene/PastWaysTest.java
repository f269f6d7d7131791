package org.robotui.ui.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.robotui.testkit.KeptHistory.BEGIN;
import static org.robotui.testkit.KeptHistory.SECOND;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.SourceId;
import org.robotui.api.time.PointedTime;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.Odometry;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.KeptHistory;
import org.robotui.testkit.KeptTimeline;

class PastWaysTest {
  private static final SourceId ODOM = new SourceId("base", "odom");
  private static final FrameId FRAME = new FrameId("Keira", "odom");

  private final PointedTime pointed = new PointedTime();
  private final FakeInput<Odometry> input = new FakeInput<>();
  private final KeptHistory history = new KeptHistory(new KeptTimeline());
  private final PastWays ways = new PastWays(pointed, Runnable::run);

  private Map<String, PastSpot> at(double seconds) {
    pointed.point(this, BEGIN + Math.round(seconds * SECOND));
    ways.spots(input, List.of(ODOM)); // has it read
    return ways.spots(input, List.of(ODOM));
  }

  private void drive() {
    for (int second = 0; second <= 10; second++) {
      history.add("odom", second, new Odometry(FRAME, new FrameId("Keira", "base_link"),
          RigidTransform.planar(second, 2, Math.PI / 2), Doubles.EMPTY, Vector3.ZERO, Vector3.ZERO, Doubles.EMPTY));
    }
    input.history(ODOM, history);
  }

  @Test
  void theRobotIsWhereItWasAtTheTimeOfThePointer() {
    drive();
    assertEquals(Map.of(), ways.spots(input, List.of(ODOM)));
    PastSpot spot = at(4.25).get("Keira");
    assertEquals(FRAME, spot.frame());
    assertEquals(4.25, spot.pose().translation().x(), 1e-6);
    assertEquals(Math.PI / 2, spot.pose().rotation().yaw(), 1e-6);
    assertEquals(11, spot.way().size());
    assertSame(spot.way(), at(9).get("Keira").way());
    assertEquals(1, history.readings());
    pointed.leave(this);
    assertEquals(Map.of(), ways.spots(input, List.of(ODOM)));
  }

  @Test
  void itIsNowhereBeforeItsRecordingAndMovesWithIt() {
    drive();
    assertTrue(at(-2).isEmpty());
    assertTrue(at(12).isEmpty());
    history.offset(10 * SECOND);
    assertEquals(2, at(12).get("Keira").pose().translation().x(), 1e-6);
  }

  @Test
  void liveRobotsAndDamagedRecordingsDoNotMatter() {
    assertTrue(at(3).isEmpty());
    drive();
    history.fail("run.mcap cannot be read at byte 12");
    assertEquals(3, at(3).get("Keira").pose().translation().x(), 1e-6);
  }
}
