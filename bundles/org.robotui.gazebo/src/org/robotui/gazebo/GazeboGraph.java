package org.robotui.gazebo;

import java.util.List;

/**
 * What the other processes of a partition have, at one moment.
 *
 * @param topics that they publish, one for each node that does
 * @param services that they answer, one for each node that does
 * @param subscriptions topics to which they subscribe, as far as they have said so: those of ours, and all where their
 * transport is newer than 11 and somebody has asked for them
 * @param processes those that were heard lately, also if they have nothing
 */
public record GazeboGraph(List<OfferedTopic> topics, List<OfferedService> services, List<OfferedTopic> subscriptions,
    List<String> processes) {
  /** With nothing in it. */
  public static final GazeboGraph EMPTY = new GazeboGraph(List.of(), List.of(), List.of(), List.of());

  /** Takes copies. */
  public GazeboGraph {
    topics = List.copyOf(topics);
    services = List.copyOf(services);
    subscriptions = List.copyOf(subscriptions);
    processes = List.copyOf(processes);
  }
}
