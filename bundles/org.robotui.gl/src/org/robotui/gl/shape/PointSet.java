package org.robotui.gl.shape;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Optional;

/**
 * Many points. One with a coordinate that is not finite is not drawn. Order matters for thinning only: while the camera
 * moves, a renderer draws every n-th, of all or of the sample.
 *
 * @param xyz x, y, z in turn, metres; on the heap where sets come many a second, so that the memory of old ones is soon
 * free; direct buffers are sent to the graphics card without a copy
 * @param rgba four bytes red, green, blue, alpha a point; empty where the material colours all
 * @param size edge or diameter of a point
 * @param unit what the size is in
 * @param style how a point looks
 * @param bounds where they lie
 * @param sample fewer of them, of which every n-th is spread evenly over all; with no sample of its own
 */
public record PointSet(FloatBuffer xyz, Optional<ByteBuffer> rgba, float size, Unit unit, Style style,
    Optional<Box3> bounds, Optional<PointSet> sample)
    implements Shape {
  /** What sizes are in. */
  public enum Unit {
    /** Pixels of the picture, whatever the distance. */
    PIXELS,
    /** Metres in space. */
    METRES
  }

  /**
   * Some points.
   *
   * @param points a set
   * @param every n-th of it
   */
  public record Part(PointSet points, int every) {}

  /** How a point looks. */
  public enum Style {
    /** A square, the fastest. */
    SQUARE,
    /** A disc. */
    DISC
  }

  /**
   * Checks the sizes.
   *
   * @param xyz the points
   * @param rgba their colours
   * @param size of a point
   * @param unit of the size
   * @param style how they look
   * @param bounds where they lie
   * @param sample fewer of them, evenly spread
   */
  public PointSet {
    xyz = xyz.slice();
    Triples.check(xyz, "points");
    rgba = rgba.map(ByteBuffer::slice);
    int count = xyz.remaining() / 3;
    rgba.ifPresent(colors -> Colors.fit(colors, count));
  }

  /**
   * Points, with their bounds computed.
   *
   * @param xyz x, y, z in turn
   * @param rgba a colour each, or empty
   * @param size of a point
   * @param unit of the size
   * @return the shape
   */
  public static PointSet of(FloatBuffer xyz, Optional<ByteBuffer> rgba, float size, Unit unit) {
    return new PointSet(xyz, rgba, size, unit, Style.SQUARE, Box3.around(xyz), Optional.empty());
  }

  /**
   * What to draw where not all is to be drawn.
   *
   * @param every n-th of all points is wanted
   * @return as many, or some more
   */
  public Part part(int every) {
    return every == 1 ? new Part(this, 1)
        : sample.filter(s -> s.elements() >= elements() / every)
            .map(s -> new Part(s, (int) Math.max(1, (long) every * s.elements() / elements())))
            .orElseGet(() -> new Part(this, every));
  }

  @Override
  public int elements() {
    return xyz.remaining() / 3;
  }

  @Override
  public long bytes() {
    return elements() * (rgba.isPresent() ? 16L : 12L) + sample.map(PointSet::bytes).orElse(0L);
  }
}
