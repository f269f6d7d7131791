package org.robotui.roboframe.internal;

/** Which message a frame holds, by its first byte. */
enum FrameKind {
  HELLO,
  BOARD,
  VALUE,
  PING,
  PONG;

  /** Before all else that an application says. */
  static final int MAGIC = 0x52464252;
}
