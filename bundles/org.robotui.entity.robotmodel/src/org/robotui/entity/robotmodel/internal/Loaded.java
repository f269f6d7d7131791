package org.robotui.entity.robotmodel.internal;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.urdf.Kinematics;
import org.robotui.urdf.RobotModel;
import org.robotui.urdf.SemanticModel;

/** What came of a load. */
sealed interface Loaded {
  /**
   * A model.
   *
   * @param model the robot
   * @param kinematics where its links are
   * @param semantics its groups
   * @param forms what is drawn, by link
   * @param problems what is missing, each with what would help
   */
  record Model(
      RobotModel model, Kinematics kinematics, Optional<SemanticModel> semantics, Map<String, List<Form>> forms,
      List<String> problems)
      implements Loaded {}

  /**
   * There is no model.
   *
   * @param why what is wrong with the text
   */
  record Broken(String why) implements Loaded {}
}
