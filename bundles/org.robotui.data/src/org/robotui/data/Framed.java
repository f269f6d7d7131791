package org.robotui.data;

import java.util.stream.Stream;

/**
 * What is given in coordinate frames. Views ask which these are, to place it and to offer them as frames to draw in.
 */
public interface Framed {
  /**
   * The frames that it names.
   *
   * @return in any order, each as often as it is named, none with an empty name
   */
  Stream<FrameId> frames();
}
