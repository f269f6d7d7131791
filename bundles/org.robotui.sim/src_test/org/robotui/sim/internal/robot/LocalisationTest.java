package org.robotui.sim.internal.robot;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.sim.internal.world.Pose2;

class LocalisationTest {
  private final Pose2 truth = new Pose2(3, 2, 1);
  private final Pose2 odometry = new Pose2(1, 0.5, 0.2);
  private final Localisation localisation = new Localisation(new Random(3), Pose2.ORIGIN);

  @Test
  void aSlightlyWrongPoseIsCorrected() {
    localisation.set(new Pose2(3.5, 2.3, 1.2), odometry);
    update(75);
    assertTrue(localisation.estimate(odometry).distanceTo(truth) < 0.03);
    assertFalse(localisation.isLost());
  }

  @Test
  void aFarWrongPoseStaysWrongUntilSetAgain() {
    localisation.set(new Pose2(9, 8, 1), odometry);
    update(200);
    assertTrue(localisation.isLost());
    assertTrue(localisation.estimate(odometry).distanceTo(truth) > 5);
    localisation.set(truth, odometry);
    update(1);
    assertFalse(localisation.isLost());
  }

  private void update(int times) {
    for (int i = 0; i < times; i++) {
      localisation.update(truth, odometry, 0.2, false);
    }
  }
}
