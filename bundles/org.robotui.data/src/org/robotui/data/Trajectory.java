package org.robotui.data;

/** How joints shall move over time: what a controller is told, or what a planner shows. */
@Delivery(expires = false)
public sealed interface Trajectory extends Data permits JointTrajectory, DisplayedTrajectory {}
