package org.robotui.roboframe.board;

/** The use of a key by a module, until it is closed. */
public interface KeyUse extends AutoCloseable {
  @Override
  void close();
}
