package org.robotui.rtps;

/** The two ends of a topic. */
public enum EndpointKind {
  /** It sends samples: a publisher, in words of ROS. */
  WRITER,
  /** It receives samples: a subscription, in words of ROS. */
  READER
}
