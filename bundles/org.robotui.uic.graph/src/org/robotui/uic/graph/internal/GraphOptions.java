package org.robotui.uic.graph.internal;

import java.util.List;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;

/**
 * What the view can be configured with, beside what its buttons keep.
 *
 * @param periodNanos the least time between two questions to the robot
 * @param measured how many topics may be measured at once
 * @param boxes from how many boxes on namespaces are closed until they are opened
 */
public record GraphOptions(long periodNanos, int measured, int boxes) {
  static final String PERIOD = "refresh_period";
  static final String MEASURED = "max_measured";
  static final String BOXES = "close_from";
  static final String SHOW = "show";
  static final String NODES = "nodes";
  static final String ALL = "topics";
  static final String DEBUG = "hide_tools";
  static final String TF = "hide_tf";
  static final String ENDS = "hide_dead_ends";
  static final String GROUPS = "groups";

  private static final double NANOS = 1e9;

  /** The settings. */
  public static Schema schema() {
    return Schema.of(
        Setting.of(SHOW, new ValueType.Choice(List.of(NODES, ALL)), ALL,
            "Whether topics have boxes, or are wires from node to node."),
        Setting.of(DEBUG, new ValueType.Flag(), true,
            "Whether tools (rviz, rqt, recorders, RobotUI itself) and their topics, such as /rosout, are left out."),
        Setting.of(TF, new ValueType.Flag(), true, "Whether /tf and /tf_static are left out."),
        Setting.of(ENDS, new ValueType.Flag(), true,
            "Whether dead ends, which are topics without a publisher or without a subscriber, are left out."),
        Setting.of(GROUPS, new ValueType.Flag(), true, "Whether a frame is drawn around what lies in one namespace."),
        Setting.of(BOXES, new ValueType.Int(10, 1000), 120L,
            "From how many boxes on namespaces are closed until they are opened."),
        Setting.of(PERIOD, new ValueType.Num(0.5, 60, "s"), 2.0,
            "How often the robot is asked what it has, while the view is seen."),
        Setting.of(MEASURED, new ValueType.Int(1, 100), 20L, "How many topics may be measured at once."));
  }

  /** From settings. */
  public static GraphOptions of(Settings settings) {
    return new GraphOptions(Math.round(settings.number(PERIOD) * NANOS), Math.toIntExact(settings.integer(MEASURED)),
        Math.toIntExact(settings.integer(BOXES)));
  }
}
