package org.robotui.gl.shape;

import org.robotui.geometry.Vector3;

/** What a part says when it is selected. */
@FunctionalInterface
public interface Describer {
  /**
   * Describes one element. Called on any thread, also after newer parts were made; must not block.
   *
   * @param element which point, segment, triangle or instance of the shape, from 0
   * @param place where it was hit, in the shape's frame, metres
   * @return its properties
   */
  Properties describe(int element, Vector3 place);

  /**
   * The same words for all of a part.
   *
   * @param title what it is
   * @return the describer
   */
  static Describer of(String title) {
    return (element, place) -> Properties.of(title);
  }
}
