package org.robotui.geometry;

/**
 * How much a {@link TransformBuffer} holds.
 *
 * @param cacheNanos how far back from the newest sample an edge remembers, nanoseconds
 * @param maxEdges most edges, which is the same as frames with a parent
 * @param maxSamples most samples of an edge; the oldest go first
 */
public record TransformLimits(long cacheNanos, int maxEdges, int maxSamples) {
  /** Ten seconds, 1000 edges, 4000 samples of each edge. */
  public static final TransformLimits DEFAULT = new TransformLimits(10_000_000_000L, 1000, 4000);

  /**
   * Checks that the limits allow anything.
   *
   * @param cacheNanos how far back from the newest sample an edge remembers, nanoseconds
   * @param maxEdges most edges, which is the same as frames with a parent
   * @param maxSamples most samples of an edge
   */
  public TransformLimits {
    if (cacheNanos < 0 || maxEdges < 1 || maxSamples < 1) {
      throw new IllegalArgumentException(
          "limits need a cache of at least 0 ns, 1 edge and 1 sample: " + cacheNanos + ", " + maxEdges + ", "
              + maxSamples);
    }
  }
}
