package org.robotui.api.replay;

import java.util.List;

/**
 * One topic of a recording.
 *
 * @param topic its name
 * @param type the robot's name of its type, empty where it is not known
 * @param count how many messages it has; -1 where that is not known without reading the whole file
 * @param density how many messages lie in each of equally long parts of the recording's time, from its start to its
 * end; empty where that is not known yet
 */
public record Lane(String topic, String type, long count, List<Integer> density) {
  /**
   * Copies the list.
   *
   * @param topic its name
   * @param type of its messages
   * @param count of messages
   * @param density over time
   */
  public Lane {
    density = List.copyOf(density);
  }
}
