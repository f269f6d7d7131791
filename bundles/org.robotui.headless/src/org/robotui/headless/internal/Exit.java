package org.robotui.headless.internal;

/** How the process ends: the numbers that scripts may rely on. */
enum Exit {
  /** All is well. */
  FINE(0),
  /** The configuration has errors. */
  ERRORS(1),
  /** A file cannot be read. */
  UNREADABLE(2),
  /** An argument is wrong. */
  USAGE(3),
  /** The core did not start. */
  NO_CORE(4),
  /** A script failed, or was stopped. */
  SCRIPT(5),
  /** A recording could not be begun, or ended by itself. */
  RECORDING(6),
  /** There is no bridge to run, or its numbers cannot be given. */
  BRIDGE(7);

  private final int code;

  Exit(int code) {
    this.code = code;
  }

  int code() {
    return code;
  }
}
