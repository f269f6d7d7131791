package org.robotui.data.status;

/** How bad it is. */
public enum Severity {
  /** For developers. */
  DEBUG,
  /** As it should be. */
  INFO,
  /** Worth a look. */
  WARNING,
  /** Something does not work. */
  ERROR,
  /** Nothing works. */
  FATAL
}
