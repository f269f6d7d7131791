package org.robotui.xbot.internal;

/** Where in the state of a joint what lies. */
final class JointFields {
  final int linkPosition;
  final int motorPosition;
  final int linkVelocity;
  final int motorVelocity;
  final int effort;
  final int positionReference;
  final int velocityReference;
  final int effortReference;
  final int stiffness;
  final int damping;
  final int motorTemperature;
  final int driverTemperature;
  final int fault;
  final int clamped;
  final int rejected;
  final int owner;
  final int mode;
  final int control;
  final int nobody;

  JointFields(Layout layout) {
    this.linkPosition = layout.offset("JointState", "link_position");
    this.motorPosition = layout.offset("JointState", "motor_position");
    this.linkVelocity = layout.offset("JointState", "link_velocity");
    this.motorVelocity = layout.offset("JointState", "motor_velocity");
    this.effort = layout.offset("JointState", "effort");
    this.positionReference = layout.offset("JointState", "position_reference");
    this.velocityReference = layout.offset("JointState", "velocity_reference");
    this.effortReference = layout.offset("JointState", "effort_reference");
    this.stiffness = layout.offset("JointState", "stiffness");
    this.damping = layout.offset("JointState", "damping");
    this.motorTemperature = layout.offset("JointState", "temperature_motor");
    this.driverTemperature = layout.offset("JointState", "temperature_driver");
    this.fault = layout.offset("JointState", "fault");
    this.clamped = layout.offset("JointState", "clamped");
    this.rejected = layout.offset("JointState", "rejected");
    this.owner = layout.offset("JointState", "owner");
    this.mode = layout.offset("JointState", "mode");
    this.control = layout.offset("JointState", "control");
    this.nobody = layout.number("nobody");
  }
}
