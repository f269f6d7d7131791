package org.robotui.ui.scene;

import java.util.Optional;

/**
 * A building block of a map: knows how to draw itself and never where its data comes from. Each has a method of its own
 * to prepare what is to be drawn, called on a worker, which must publish it as one immutable value; the methods here
 * use the last value published.
 */
public interface Entity {
  /**
   * Paints what was prepared last, nothing before the first. Display thread; must neither block nor compute at length.
   *
   * @param painter where
   */
  void paint(Painter painter);

  /**
   * How far it reaches in the fixed frame. Any thread.
   *
   * @return the bounds, or none where there is nothing to see
   */
  Optional<Bounds> bounds();

  /**
   * What of it lies at a point, for tooltips. Any thread.
   *
   * @param x metres in the fixed frame
   * @param y metres in the fixed frame
   * @param tolerance how far away still counts, metres
   * @return what is there, or none
   */
  Optional<Description> describeAt(double x, double y, double tolerance);

  /** Releases what it holds of the display. Display thread; it may be painted again, which makes these things anew. */
  default void dispose() {}
}
