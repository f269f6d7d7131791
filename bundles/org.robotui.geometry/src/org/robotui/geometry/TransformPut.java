package org.robotui.geometry;

import java.util.Optional;

/**
 * What became of a transform given to a {@link TransformBuffer}.
 *
 * @param <F> names a frame
 */
public sealed interface TransformPut<F> {
  /**
   * It was stored.
   *
   * @param formerParent the parent the child had before, where it has got a new one; its history is forgotten
   * @param <F> names a frame
   */
  record Accepted<F>(Optional<F> formerParent) implements TransformPut<F> {}

  /**
   * It was not stored; the buffer is as before.
   *
   * @param reason why, for a user to read
   * @param <F> names a frame
   */
  record Refused<F>(String reason) implements TransformPut<F> {}
}
