package org.robotui.api.port;

/** What passes through a port. */
public enum PortKind {
  /** Data out of a robot. */
  STREAM,
  /** Commands into a robot. */
  COMMAND,
  /** A request with a reply. */
  CALL,
  /** What a robot has: lists, descriptions, parameters. */
  BROWSE
}
