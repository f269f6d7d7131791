package org.robotui.sim.internal.message;

/** What kind of messages a topic carries, of which each generation of ROS makes what its nodes do. */
public enum TopicKind {
  /** Many, of which only the newest counts. */
  SENSOR,
  /** Pictures and clouds: large, and only the newest counts. */
  LARGE,
  /** None should be missed, but who comes late waits for the next one. */
  STATE,
  /** As {@link #STATE}, but so seldom that nodes of ROS 1 keep the last one for who comes late. */
  SELDOM,
  /** The last one is kept for who comes late. */
  LATCHED,
  /** Transforms that change. */
  TRANSFORMS,
  /** The time of a simulation. */
  CLOCK
}
