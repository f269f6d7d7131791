package org.robotui.message.ros.rcl_interfaces;

import org.robotui.message.MessageType;

/**
 * What a program of a ROS 2 robot said ({@code rcl_interfaces/Log}).
 *
 * @param stamp when, nanoseconds since the epoch of the sender's clock
 * @param level how bad it is: one of the constants, or between them
 * @param name of the logger
 * @param msg what was said
 * @param file the source file
 * @param function the function
 * @param line the line of the file
 */
@MessageType("rcl_interfaces/Log")
public record RclLog(long stamp, int level, String name, String msg, String file, String function, long line) {

  /** For developers. */
  public static final int DEBUG = 10;
  /** All is well. */
  public static final int INFO = 20;
  /** Something may go wrong. */
  public static final int WARN = 30;
  /** Something went wrong. */
  public static final int ERROR = 40;
  /** The program cannot go on. */
  public static final int FATAL = 50;
}
