package org.robotui.xbot.internal;

import java.util.Map;

/** Where in a frame what lies: asked of the layout once, since frames are read often. */
final class FrameFields {
  final int size;
  final int cycle;
  final int sensed;
  final int status;
  final Layout.Field joints;
  final Layout.Field imus;
  final Layout.Field forceTorques;
  final JointFields joint;
  final int orientation;
  final int angularVelocity;
  final int linearAcceleration;
  final int force;
  final int torque;

  FrameFields(Layout layout) {
    Map<String, Layout.Field> fields = layout.struct("FrameData").fields();
    this.size = layout.size("FrameData");
    this.cycle = fields.get("cycle").offset();
    this.sensed = fields.get("sensed_ns").offset();
    this.status = fields.get("hal_status").offset();
    this.joints = fields.get("joints");
    this.imus = fields.get("imus");
    this.forceTorques = fields.get("force_torques");
    this.joint = new JointFields(layout);
    this.orientation = layout.offset("ImuState", "orientation");
    this.angularVelocity = layout.offset("ImuState", "angular_velocity");
    this.linearAcceleration = layout.offset("ImuState", "linear_acceleration");
    this.force = layout.offset("ForceTorqueState", "force");
    this.torque = layout.offset("ForceTorqueState", "torque");
  }
}
