package org.robotui.gl.display;

import java.util.Optional;

/**
 * One display of a scene. All methods are called on the worker thread of the scene, one at a time; they may compute for
 * some milliseconds but must not wait. What takes longer (files, meshes) goes to {@link DisplayContext#background()}.
 */
public interface Display extends AutoCloseable {
  /**
   * Takes what came since the last tick and says what is to be drawn now. Called at each tick, also when nothing came,
   * as frames move. Where nothing changed it answers the very same shapes, so that nothing is sent to the graphics
   * card.
   *
   * @param tick what came, and where things are
   * @return what is to be drawn, and how it is
   */
  DisplayResult update(DisplayTick tick);

  /**
   * What the colours of what was drawn last mean.
   *
   * @return a scale that the scene paints beside the picture; none where colours mean no numbers
   */
  default Optional<ColorScale> colors() {
    return Optional.empty();
  }

  /** Ends it: nothing is held afterwards. */
  @Override
  void close();
}
