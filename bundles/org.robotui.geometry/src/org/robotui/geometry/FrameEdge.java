package org.robotui.geometry;

/**
 * A link of a frame tree: a child frame and its parent.
 *
 * @param parent the parent frame
 * @param child the child frame
 * @param isStatic whether the transform holds for all times
 * @param oldestNanos stamp of the oldest sample; 0 where static
 * @param newestNanos stamp of the newest sample; 0 where static
 * @param samples how many samples are held
 * @param authority who sent the newest sample
 * @param <F> names a frame
 */
public record FrameEdge<F>(
    F parent, F child, boolean isStatic, long oldestNanos, long newestNanos, int samples, String authority) {

  @Override
  public String toString() {
    return "'" + parent + "' -> '" + child + "'";
  }
}
