package org.robotui.rfic.xbot.internal.task;

import org.robotui.data.joint.Trajectory;
import org.robotui.data.marker.InteractiveMarkerSet;

/** Where handles of tasks, and what is planned with them, are shown. Called on one thread. */
public interface HandleSite {
  /** Whether somebody looks at the handles. */
  boolean wanted();

  /** All handles there are now. */
  void handles(InteractiveMarkerSet now);

  /** The newest plan; one without points is none. */
  void plan(Trajectory plan);
}
