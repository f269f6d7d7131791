package org.robotui.entity.robotmodel.internal;

import org.robotui.gl.display.DisplayStatus;

/** What came of reading a trajectory. */
sealed interface PlanRead {
  /**
   * It can be shown.
   *
   * @param plan of the joints that the model has
   */
  record Ok(Plan plan) implements PlanRead {}

  /**
   * It cannot.
   *
   * @param why what is wrong with it
   */
  record Refused(DisplayStatus why) implements PlanRead {}
}
