package org.robotui.uic.map.internal;

/** The kinds of layers, lowest first. */
public enum Kind {
  /** The metric grid; it shines through the floor of maps. */
  GRID("grid", "Grid"),
  /** Grid maps. */
  MAP("map", "Map"),
  /** Sonar cones. */
  SONAR("sonar", "Sonar"),
  /** Laser scans. */
  SCAN("scan", "Laser scan"),
  /** Ways gone. */
  TRAIL("trail", "Trail"),
  /** Planned ways. */
  PATH("path", "Planned path"),
  /** Estimates of poses. */
  POSE("pose", "Pose estimate"),
  /** Bodies of robots. */
  ROBOT("robot", "Robot"),
  /** Bumpers, on the rim of bodies. */
  BUMPER("bumper", "Bumpers");

  private final String word;
  private final String label;

  Kind(String word, String label) {
    this.word = word;
    this.label = label;
  }

  /** The word in notes and settings. */
  public String word() {
    return word;
  }

  /** The name in menus. */
  public String label() {
    return label;
  }

  /** What it is made of, in notes. */
  public String data() {
    return this == TRAIL ? "odometry" : word;
  }

  /** The setting that shows or hides it. */
  public String setting() {
    return "show_" + word;
  }
}
