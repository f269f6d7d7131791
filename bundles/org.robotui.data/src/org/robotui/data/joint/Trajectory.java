package org.robotui.data.joint;

import org.robotui.data.Data;
import org.robotui.data.Delivery;

/** How joints shall move over time: what a controller is told, or what a planner shows. */
@Delivery(expires = false)
public sealed interface Trajectory extends Data permits JointTrajectory, DisplayedTrajectory {}
