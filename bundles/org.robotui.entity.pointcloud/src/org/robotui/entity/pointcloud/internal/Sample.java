package org.robotui.entity.pointcloud.internal;

import java.nio.ByteBuffer;
import java.nio.FloatBuffer;
import java.util.Optional;
import org.robotui.gl.shape.PointSet;

/**
 * An eighth of a large cloud, spread evenly, close together in memory: what a camera that moves sees. To pick it out of
 * the whole for each picture would take longer than drawing it.
 */
final class Sample {
  /** Smaller clouds are drawn as a whole. */
  static final int LARGE = 100_000;

  private static final int PART = 8;

  private Sample() {}

  /** The same points, with a sample where they are many. */
  static PointSet in(PointSet all) {
    if (all.elements() < LARGE) {
      return all;
    }
    return new PointSet(all.xyz(), all.rgba(), all.size(), all.unit(), all.style(), all.bounds(), Optional.of(of(all)));
  }

  private static PointSet of(PointSet all) {
    int total = all.elements();
    int step = Order.step(total);
    float[] xyz = new float[3 * (total / PART)];
    ByteBuffer rgba = ByteBuffer.allocate(all.rgba().isPresent() ? Integer.BYTES * (total / PART) : 0);
    ByteBuffer colors = all.rgba().orElse(rgba);
    int source = 0;
    for (int i = 0; i < xyz.length; i += 3) {
      all.xyz().get(3 * source, xyz, i, 3);
      if (rgba.hasRemaining()) {
        rgba.putInt(colors.getInt(Integer.BYTES * source));
      }
      source = (int) (((long) source + step) % total);
    }
    return new PointSet(FloatBuffer.wrap(xyz), all.rgba().map(c -> rgba.flip()), all.size(), all.unit(), all.style(),
        all.bounds(), Optional.empty());
  }
}
