package org.robotui.entity.odometry.internal.display;

import java.util.List;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.data.array.Doubles;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.render.Eye;
import org.robotui.gl.shape.Part;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;
import org.robotui.testkit.display.DisplayProbe;
import org.robotui.testkit.display.FakePlaces;

/** How odometry, estimates, poses and goals look. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class PosePicturesTest {
  @AutoClose
  private static final ScenePictures PICTURES = new ScenePictures();

  private static final Eye EYE = ScenePictures.eye(new Vector3(-0.3, -0.25, 1), new Vector3(0.55, 0.3, 0));
  private static final RigidTransform THERE = RigidTransform.planar(0.8, 0.4, Math.PI / 4);
  /** Surer along x than along y, and of its heading to some 20 degrees. */
  private static final Doubles UNSURE = covariance(0.01, 0.06, 0.002, 0.12);

  private static Doubles covariance(double x, double y, double z, double yaw) {
    double[] all = new double[Odometry.COVARIANCE_SIZE];
    all[0] = x;
    all[7] = y;
    all[14] = z;
    all[35] = yaw;
    return Doubles.of(all);
  }

  private static void show(String name, List<Part> parts) {
    PICTURES.assertLike(PosePicturesTest.class, name, ScenePictures.request(ScenePictures.withAxes(parts, 0.4), EYE));
  }

  @Test
  void odometryIsATrailOfArrowsWithTheUncertaintyOfTheLast() {
    try (DisplayProbe probe = new DisplayProbe(new OdometryType())) {
      probe.places().put("odom", RigidTransform.IDENTITY);
      for (int i = 0; i < 6; i++) {
        RigidTransform pose = RigidTransform.planar(0.25 * i, 0.03 * i * i, 0.06 * 4 * i);
        probe.tick(new Odometry(FakePlaces.frame("odom"), FakePlaces.frame("base"), pose, UNSURE, Vector3.ZERO,
            Vector3.ZERO, Doubles.EMPTY));
      }
      show("odometry", probe.parts());
    }
  }

  @Test
  void anEstimateSaysHowSureItIs() {
    try (DisplayProbe probe = new DisplayProbe(new PoseEstimateType())) {
      show("estimate", probe.parts(new PoseEstimate(FakePlaces.frame("map"), THERE, UNSURE)));
    }
  }

  @Test
  void aPoseIsAnArrowOrAxes() {
    try (DisplayProbe probe = new DisplayProbe(new StampedPoseType())) {
      show("pose", probe.parts(new StampedPose(FakePlaces.frame("map"), THERE)));
      show("pose-axes", probe.set("shape", "axes").parts());
    }
  }

  @Test
  void aGoalIsAGreenArrow() {
    try (DisplayProbe probe = new DisplayProbe(new GoalType())) {
      show("goal", probe.parts(new NavigationGoal(FakePlaces.frame("map"), THERE)));
    }
  }
}
