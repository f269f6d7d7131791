package org.robotui.data;

/** Whose clock a time stamp was read from. */
public enum ClockKind {
  /** The clock of this machine. */
  WALL,
  /** The clock of the robot, which may be off by an unknown offset. */
  ROBOT,
  /** A simulator's time, which may stop and jump back. */
  SIMULATED,
  /** The time within a recording. */
  REPLAY
}
