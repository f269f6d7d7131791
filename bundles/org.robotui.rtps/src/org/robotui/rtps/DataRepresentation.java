package org.robotui.rtps;

/** How samples become bytes. The first bytes of each sample say which one it uses, and in which byte order. */
public enum DataRepresentation {
  /** Plain CDR, or parameter lists: what ROS 2 uses. */
  XCDR1,
  /** Text. */
  XML,
  /** The second version, which some use for types that may grow. */
  XCDR2
}
