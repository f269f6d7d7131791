package org.robotui.entity.robotmodel.internal;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Part;
import org.robotui.testkit.Displays;
import org.robotui.testkit.ScenePictures;
import org.robotui.testkit.display.DisplayProbe;

/** How a plan looks over the robot that executes it badly. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class TrajectoryPictureTest {
  @Test
  void aGhostWithItsTrailOverTheArm() {
    ModelShelf shelf = new ModelShelf();
    try (DisplayProbe robot = new DisplayProbe(new RobotModelType(shelf));
        DisplayProbe plan = new DisplayProbe(new TrajectoryType(shelf));
        ScenePictures pictures = new ScenePictures()) {
      robot.places().put("base", RigidTransform.IDENTITY);
      plan.places().put("base", RigidTransform.IDENTITY);
      plan.set(TrajectoryType.LINK, "tool").set(TrajectoryType.REPEAT, "end").set(TrajectoryType.TRAIL, 5L);
      plan.tick(Arm.description(), Arm.at(0, 0), Arm.sweep(11));
      for (int i = 0; i <= 6; i++) {
        plan.tick(Arm.at(0.1 * i, 0.01 * i * i));
      }
      robot.tick(Arm.description());
      List<Part> parts = new ArrayList<>();
      robot.parts(Arm.at(0.6, 0.36)).forEach(
          part -> parts.add(new Part(List.of("robot", part.key()), part.shape(), part.fixedFromShape(), part.material(),
              part.describer())));
      parts.addAll(plan.parts());
      pictures.assertLike(TrajectoryPictureTest.class, "trajectory", ScenePictures.request(parts,
          ScenePictures.eye(new Vector3(2.1, -1, 1.6), new Vector3(0.2, 0.2, 0.5))));
    }
  }
}
