package org.robotui.rfic.carmen.internal.feed;

import java.util.Set;

/** For whom a message is, which neither a central nor IPC knows: it is told by names. */
public enum Direction {
  /** Robots say it. */
  FROM_ROBOT,
  /** Robots are told it. */
  TO_ROBOT,
  /** Robots are asked it, and answer. */
  QUESTION,
  /** Robots say it to who has asked, and to nobody else. */
  ANSWER,
  /** It drives the robot: only views for driving may say it. */
  DRIVES;

  private static final Set<String> DRIVING = Set.of("carmen_robot_vel", "carmen_base_velocity",
      "carmen_robot_vector_move", "carmen_robot_follow_trajectory");
  private static final Set<String> SAID = Set.of("carmen_param_version", "carmen_placelist_message",
      "carmen_offlimits_message", "carmen_global_offset_message", "carmen_localize_map", "carmen_hmap_message",
      "carmen_change_map_zone_response");
  private static final Set<String> TOLD = Set.of("carmen_navigator_go", "carmen_navigator_stop",
      "carmen_navigator_set_goal", "carmen_navigator_set_goal_triplet", "carmen_localize_initialize",
      "carmen_localize_initialize_placename", "carmen_simulator_set_truepose", "carmen_simulator_set_object",
      "carmen_simulator_clear_objects", "carmen_simulator_next_tick", "carmen_simulator_connect_robots",
      "carmen_logger_sync", "carmen_logger_comment");

  /** The direction of a message. */
  public static Direction of(String message) {
    if (DRIVING.contains(message)) {
      return DRIVES;
    }
    if (TOLD.contains(message)) {
      return TO_ROBOT;
    }
    if (SAID.contains(message) || message.contains("_respond_")) {
      return ANSWER;
    }
    boolean asks = message.endsWith("_query") || message.endsWith("_request") || message.contains("_query_")
        || message.endsWith("_command") || message.equals("carmen_param_set");
    return asks ? QUESTION : FROM_ROBOT;
  }
}
