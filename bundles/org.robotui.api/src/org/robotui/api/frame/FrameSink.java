package org.robotui.api.frame;

import org.robotui.data.geometry.TransformSet;

/** Takes the transforms that a robot interface receives. */
@FunctionalInterface
public interface FrameSink {
  /**
   * Adds transforms. Never blocks; transforms that cannot be (a cycle, no rotation) are refused, counted and logged.
   *
   * @param transforms the transforms
   * @param authority who says so, for messages
   */
  void add(TransformSet transforms, String authority);
}
