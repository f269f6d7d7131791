package org.robotui.ros2;

import org.robotui.message.ros.rcl_interfaces.RclLog;

/** How bad an entry of the log is. */
public enum Ros2LogLevel {

  /** For developers. */
  DEBUG(RclLog.DEBUG),
  /** As it should be. */
  INFO(RclLog.INFO),
  /** Worth a look. */
  WARN(RclLog.WARN),
  /** Something does not work. */
  ERROR(RclLog.ERROR),
  /** Nothing works any more. */
  FATAL(RclLog.FATAL);

  private final int code;

  Ros2LogLevel(int code) {
    this.code = code;
  }

  int code() {
    return code;
  }
}
