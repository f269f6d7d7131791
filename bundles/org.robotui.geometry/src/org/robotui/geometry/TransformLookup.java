package org.robotui.geometry;

import java.util.Locale;
import java.util.Optional;

/**
 * What a transform buffer answers.
 *
 * @param <F> what names a frame
 */
public sealed interface TransformLookup<F> {
  /**
   * A sentence for users: why there is no transform, or empty where there is one.
   *
   * @return the explanation
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
   * There is one.
   *
   * @param <F> what names a frame
   * @param targetFromSource the transform
   * @param stampNanos the time at which it holds; 0 in the answer to a question for the latest one where all is static
   */
  record Found<F>(RigidTransform targetFromSource, long stampNanos) implements TransformLookup<F> {
    @Override
    public String explanation() {
      return "";
    }

    @Override
    public Optional<RigidTransform> transform() {
      return Optional.of(targetFromSource);
    }
  }

  /**
   * A frame was never heard of.
   *
   * @param <F> what names a frame
   * @param frame the frame
   */
  record UnknownFrame<F>(F frame) implements TransformLookup<F> {
    @Override
    public String explanation() {
      return "nobody publishes a transform of frame " + frame;
    }
  }

  /**
   * Both frames are known, but no chain leads from one to the other.
   *
   * @param <F> what names a frame
   * @param target the asked target
   * @param targetRoot the root of its tree
   * @param source the asked source
   * @param sourceRoot the root of its tree
   */
  record Disconnected<F>(F target, F targetRoot, F source, F sourceRoot) implements TransformLookup<F> {
    @Override
    public String explanation() {
      return "no transform links " + target + " and " + source + ": a transform between " + targetRoot + " and "
          + sourceRoot + " is missing";
    }
  }

  /**
   * The chain is known, but not any more for so long ago.
   *
   * @param <F> what names a frame
   * @param parent the parent of the link that has forgotten
   * @param child its child
   * @param oldestNanos the oldest time that the link knows
   * @param askedNanos the asked time
   */
  record TooOld<F>(F parent, F child, long oldestNanos, long askedNanos) implements TransformLookup<F> {
    @Override
    public String explanation() {
      return "the transform " + parent + " -> " + child + " is known only since "
          + seconds(oldestNanos - askedNanos) + " s after the asked time";
    }
  }

  /**
   * The chain is known, but not yet at so late a time.
   *
   * @param <F> what names a frame
   * @param parent the parent of the link that is behind
   * @param child its child
   * @param newestNanos the newest time that the link knows
   * @param askedNanos the asked time
   */
  record TooNew<F>(F parent, F child, long newestNanos, long askedNanos) implements TransformLookup<F> {
    @Override
    public String explanation() {
      return "the transform " + parent + " -> " + child + " is "
          + seconds(askedNanos - newestNanos) + " s behind the asked time";
    }
  }

  /**
   * The links of the chain never knew a common time.
   *
   * @param <F> what names a frame
   * @param target the asked target
   * @param source the asked source
   */
  record NoCommonTime<F>(F target, F source) implements TransformLookup<F> {
    @Override
    public String explanation() {
      return "the transforms between " + target + " and " + source + " have no time in common";
    }
  }

  private static String seconds(long nanos) {
    return String.format(Locale.ROOT, "%.2f", nanos * 1e-9);
  }
}
