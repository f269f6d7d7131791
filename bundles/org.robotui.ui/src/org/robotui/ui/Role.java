package org.robotui.ui;

/** What a colour is for. The theme gives a colour to every role. */
public enum Role {
  /** Behind all parts, in wells, and behind words over content. */
  GROUND,
  /** Behind the content of views, lists and controls. */
  PANEL,
  /** Behind title lines. */
  TITLE,
  /** Thin lines between things, grids. */
  LINE,
  /** Text and figures. */
  TEXT,
  /** Text of lesser weight. */
  DIM,
  /** What is selected, driven or to be touched. */
  ACCENT,
  /** As it should be. */
  GOOD,
  /** Worth a look. */
  WARNING,
  /** Broken, and the stop. */
  BAD,
  /** Echoes of a laser. */
  LASER,
  /** Sonar cones. */
  SONAR,
  /** Walls of a map. */
  WALL,
  /** Free floor of a map. */
  FLOOR,
  /** A planned way and its goal. */
  PLAN,
  /** The way gone. */
  TRAIL
}
