package org.robotui.ros.tf;

/**
 * Where transforms are published.
 *
 * @param moving the topic of transforms that change
 * @param fixed the topic of transforms that hold for all times; its publishers latch
 */
public record TfTopics(String moving, String fixed) {

  /** The topics every ROS robot uses: {@code /tf} and {@code /tf_static}. */
  public static final TfTopics STANDARD = new TfTopics("/tf", "/tf_static");
}
