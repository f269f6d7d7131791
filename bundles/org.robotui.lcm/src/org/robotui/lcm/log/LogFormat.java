package org.robotui.lcm.log;

/** The numbers of LCM's log format. */
final class LogFormat {

  /** The first word of each event. */
  static final int SYNC = 0xEDA1DA01;
  static final int HEADER = 28;
  /** No program writes longer names of channels; a longer one is damage. */
  static final int MOST_CHANNEL = 1000;

  private LogFormat() {}
}
