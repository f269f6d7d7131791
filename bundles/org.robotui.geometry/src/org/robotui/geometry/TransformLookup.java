package org.robotui.geometry;

import java.util.Locale;
import java.util.Optional;

/**
 * The answer to the question for a transform.
 *
 * @param <F> names a frame
 */
public sealed interface TransformLookup<F> {
  /**
   * Says what was found, or why nothing was.
   *
   * @return a sentence for a user
   */
  String explanation();

  /**
   * The transform, where there is one.
   *
   * @return target from source
   */
  default Optional<RigidTransform> transform() {
    return Optional.empty();
  }

  /**
   * The transform is known.
   *
   * @param targetFromSource the transform
   * @param stampNanos the time it holds for; 0 in the answer to a question for the latest one where all is static
   * @param <F> names a frame
   */
  record Found<F>(RigidTransform targetFromSource, long stampNanos) implements TransformLookup<F> {
    @Override
    public String explanation() {
      return "known at " + seconds(stampNanos);
    }

    @Override
    public Optional<RigidTransform> transform() {
      return Optional.of(targetFromSource);
    }
  }

  /**
   * Nobody ever sent a transform of this frame.
   *
   * @param frame the frame
   * @param <F> names a frame
   */
  record UnknownFrame<F>(F frame) implements TransformLookup<F> {
    @Override
    public String explanation() {
      return "no transform of the frame '" + frame + "' was received";
    }
  }

  /**
   * The frames are in separate trees.
   *
   * @param target the target frame
   * @param targetRoot the root of its tree
   * @param source the source frame
   * @param sourceRoot the root of its tree
   * @param <F> names a frame
   */
  record Disconnected<F>(F target, F targetRoot, F source, F sourceRoot) implements TransformLookup<F> {
    @Override
    public String explanation() {
      return "'" + target + "' and '" + source + "' are not connected: a transform between '" + targetRoot
          + "' (the root above '" + target + "') and '" + sourceRoot + "' (the root above '" + source
          + "') is missing";
    }
  }

  /**
   * The time lies before all that is remembered.
   *
   * @param edge the edge without such old samples
   * @param oldestNanos its oldest stamp
   * @param askedNanos the time asked for
   * @param <F> names a frame
   */
  record TooOld<F>(FrameEdge<F> edge, long oldestNanos, long askedNanos) implements TransformLookup<F> {
    @Override
    public String explanation() {
      return "the transform " + edge + " is remembered from " + seconds(oldestNanos) + " on; asked for "
          + seconds(askedNanos) + ", " + seconds(oldestNanos - askedNanos) + " earlier";
    }
  }

  /**
   * The time lies after all that was received.
   *
   * @param edge the edge without such new samples
   * @param newestNanos its newest stamp
   * @param askedNanos the time asked for
   * @param <F> names a frame
   */
  record TooNew<F>(FrameEdge<F> edge, long newestNanos, long askedNanos) implements TransformLookup<F> {
    @Override
    public String explanation() {
      return "the transform " + edge + " is known up to " + seconds(newestNanos) + "; asked for "
          + seconds(askedNanos) + ", " + seconds(askedNanos - newestNanos) + " later";
    }
  }

  /**
   * There is no time at which all edges between the frames are known.
   *
   * @param early the edge that ends first
   * @param late the edge that starts last
   * @param <F> names a frame
   */
  record NoCommonTime<F>(FrameEdge<F> early, FrameEdge<F> late) implements TransformLookup<F> {
    @Override
    public String explanation() {
      return "there is no common time: the transform " + early + " ends at " + seconds(early.newestNanos())
          + ", before " + late + " starts at " + seconds(late.oldestNanos());
    }
  }

  private static String seconds(long nanos) {
    return String.format(Locale.ROOT, "%.3f s", nanos * 1e-9);
  }
}
