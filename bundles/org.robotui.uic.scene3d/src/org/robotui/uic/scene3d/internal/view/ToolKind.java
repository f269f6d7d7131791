package org.robotui.uic.scene3d.internal.view;

/** What hands can do besides moving the camera. */
enum ToolKind {
  MEASURE("measure", "Measure (M)", "Measure: click two points, or drag from one to the other \u00b7 Esc ends"),
  GOAL("goal", "Send a goal (G)",
      "Goal: press at the place, drag in the direction the robot shall face \u00b7 Esc ends"),
  POSE("initial_pose", "Pose estimate (P)",
      "Pose estimate: press where the robot is, drag in the direction it faces \u00b7 Esc ends"),
  WAYPOINTS("waypoints", "Waypoints (R)",
      "Waypoints: press at a place, drag in the direction to face \u00b7 discs move, arrows turn \u00b7 Ctrl+Z undoes \u00b7 Enter drives \u00b7 Esc ends");

  private final String id;
  private final String label;
  private final String hint;

  ToolKind(String id, String label, String hint) {
    this.id = id;
    this.label = label;
    this.hint = hint;
  }

  String id() {
    return id;
  }

  String label() {
    return label;
  }

  String hint() {
    return hint;
  }
}
