package org.robotui.data;

import java.util.stream.Stream;

/** What is given in one coordinate frame. */
public interface InFrame extends Framed {
  /**
   * The frame in which it is given.
   *
   * @return the frame; its name is empty where the robot names none
   */
  FrameId frame();

  @Override
  default Stream<FrameId> frames() {
    return Stream.of(frame()).filter(FrameId::isNamed);
  }
}
