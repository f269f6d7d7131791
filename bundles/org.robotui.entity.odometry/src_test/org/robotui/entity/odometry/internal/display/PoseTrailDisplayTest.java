package org.robotui.entity.odometry.internal.display;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.data.array.Doubles;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.shape.Part;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.display.FakePlaces;

class PoseTrailDisplayTest {
  private final DisplayProbe probe = new DisplayProbe(new OdometryType());

  @Test
  void aTrailGrowsByDistanceAndAngleAndEndsAtTheNewest() {
    probe.places().put("odom", RigidTransform.planar(10, 0, 0));
    for (int i = 0; i <= 100; i++) {
      probe.tick(at(0.01 * i, Doubles.EMPTY));
    }
    Part part = probe.parts().getFirst();
    assertTrue(part.shape().elements() >= 9 && part.shape().elements() <= 13, "" + part.shape().elements());
    assertTrue(part.describer().describe(part.shape().elements() - 1, Vector3.ZERO).toString().contains("1.000 m"));
    assertEquals(10, part.fixedFromShape().translation().x());
    assertEquals(3, probe.set("keep", 3L).parts().getFirst().shape().elements());
  }

  @Test
  void theSameShapesStayWhileNothingChanged() {
    probe.places().put("odom", RigidTransform.IDENTITY);
    List<Part> first = probe.parts(at(1, sure(0.04)));
    List<Part> second = probe.parts();
    assertEquals(3, first.size());
    for (int i = 0; i < 3; i++) {
      assertSame(first.get(i).shape(), second.get(i).shape());
    }
    assertNotSame(first.getFirst().shape(), probe.set("shape", "axes").parts().getFirst().shape());
    assertEquals(1, probe.set("covariance", false).parts().size());
    probe.close();
  }

  @Test
  void aPoseOfUnknownUncertaintyIsShown() {
    probe.places().put("odom", RigidTransform.IDENTITY);
    probe.tick(at(0, sure(Double.NaN)));
    assertEquals("1 pose", probe.tick().status().words());
  }

  @Test
  void theTrailIsForgottenWhereTheClockJumpsBack() {
    probe.places().put("odom", RigidTransform.IDENTITY);
    probe.tick(at(1, Doubles.EMPTY), at(2, Doubles.EMPTY));
    probe.reset();
    assertInstanceOf(DisplayStatus.NoData.class, probe.tick().status());
  }

  @Test
  void estimatesPosesAndGoalsAreOneArrowEach() {
    RigidTransform pose = RigidTransform.planar(1, 2, 3);
    try (DisplayProbe estimate = new DisplayProbe(new PoseEstimateType());
        DisplayProbe stamped = new DisplayProbe(new StampedPoseType());
        DisplayProbe goal = new DisplayProbe(new GoalType())) {
      estimate.tick(new PoseEstimate(FakePlaces.frame("map"), pose, Doubles.EMPTY));
      assertEquals(3,
          estimate.parts(new PoseEstimate(FakePlaces.frame("map"), RigidTransform.IDENTITY, sure(1))).size());
      assertEquals(1, estimate.parts().getFirst().shape().elements());
      assertEquals(1, stamped.parts(new StampedPose(FakePlaces.frame("map"), pose)).size());
      assertEquals(1, goal.parts(new NavigationGoal(FakePlaces.frame("map"), pose)).size());
    }
  }

  private static Odometry at(double x, Doubles covariance) {
    return new Odometry(FakePlaces.frame("odom"), FakePlaces.frame("base"), RigidTransform.planar(x, 0, 0), covariance,
        new Vector3(1, 0, 0),
        Vector3.ZERO, Doubles.EMPTY);
  }

  private static Doubles sure(double variance) {
    double[] all = new double[36];
    for (int i = 0; i < 6; i++) {
      all[7 * i] = variance;
    }
    return Doubles.of(all);
  }
}
