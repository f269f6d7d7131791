package org.robotui.entity.tf.internal.display;

import java.util.List;
import org.robotui.data.FrameId;

/**
 * Which frames are wanted.
 *
 * @param shown their names, all where empty
 * @param hidden the names of those that are not
 */
record FrameFilter(List<?> shown, List<?> hidden) {
  private static final char ANY = '*';

  boolean admits(FrameId frame) {
    return (shown.isEmpty() || names(shown, frame)) && !names(hidden, frame);
  }

  private static boolean names(List<?> patterns, FrameId frame) {
    return patterns.stream().map(Object::toString).anyMatch(pattern -> fits(pattern, frame.name())
        || fits(pattern, frame.toString()) || fits(pattern, frame.robot() + '/' + frame.name()));
  }

  private static boolean fits(String pattern, String name) {
    return !pattern.isEmpty() && pattern.charAt(pattern.length() - 1) == ANY
        ? name.startsWith(pattern.substring(0, pattern.length() - 1))
        : pattern.equals(name);
  }
}
