package org.robotui.gl.shape;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.List;
import java.util.Optional;
import org.robotui.geometry.Vector3;

/**
 * Lines.
 *
 * @param xyz x, y, z of the corners in turn, metres
 * @param rgba four bytes red, green, blue, alpha a corner; empty where the material colours all
 * @param kind how corners make lines
 * @param width pixels of the picture at 100 % scaling
 * @param bounds where they lie
 */
public record LineSet(FloatBuffer xyz, Optional<ByteBuffer> rgba, Kind kind, float width, Optional<Box3> bounds)
    implements Shape {
  /** How corners make lines. */
  public enum Kind {
    /** Each to the next. */
    STRIP,
    /** The first to the second, the third to the fourth, ... */
    SEGMENTS
  }

  /**
   * Checks the sizes.
   *
   * @param xyz the corners
   * @param rgba their colours
   * @param kind how corners make lines
   * @param width pixels
   * @param bounds where they lie
   */
  public LineSet {
    xyz = xyz.slice();
    Triples.check(xyz, "corners");
    rgba = rgba.map(ByteBuffer::slice);
    int count = xyz.remaining() / 3;
    rgba.ifPresent(colors -> Colors.fit(colors, count));
  }

  /**
   * Lines of one colour, with their bounds computed.
   *
   * @param kind how corners make lines
   * @param width pixels
   * @param xyz x, y, z of the corners in turn
   * @return the shape
   */
  public static LineSet of(Kind kind, float width, float... xyz) {
    FloatBuffer corners = FloatBuffer.wrap(xyz);
    return new LineSet(corners, Optional.empty(), kind, width, Box3.around(corners));
  }

  /**
   * Lines of one colour, with their bounds computed.
   *
   * @param kind how corners make lines
   * @param width pixels
   * @param corners in turn
   * @return the shape
   */
  public static LineSet of(Kind kind, float width, List<Vector3> corners) {
    float[] xyz = new float[3 * corners.size()];
    for (int i = 0; i < corners.size(); i++) {
      xyz[3 * i] = (float) corners.get(i).x();
      xyz[3 * i + 1] = (float) corners.get(i).y();
      xyz[3 * i + 2] = (float) corners.get(i).z();
    }
    return of(kind, width, xyz);
  }

  @Override
  public int elements() {
    int corners = xyz.remaining() / 3;
    return kind == Kind.STRIP ? Math.max(0, corners - 1) : corners / 2;
  }

  @Override
  public long bytes() {
    return xyz.remaining() / 3 * (rgba.isPresent() ? 16L : 12L);
  }
}
