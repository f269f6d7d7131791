package org.robotui.rfic.carmen.internal.convert;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.navigation.GridMap;
import org.robotui.geometry.RigidTransform;
import org.robotui.net.packed.Zlib;

/**
 * Grid maps. CARMEN sends probabilities as floats of the sender's machine, packed by zlib, column after column: all of
 * x = 0 first. Less than zero means that nothing is known.
 */
public final class CarmenGrids {
  /** The most cells of a map; a larger one is refused before anything is kept for it. */
  private static final long MOST_CELLS = 1L << 26;
  private static final int CERTAIN = 100;

  private CarmenGrids() {}

  public static GridMap of(IpcRecord m, ByteOrder order, FrameId frame) {
    IpcRecord config = m.record("config");
    int width = config.whole("x_size");
    int height = config.whole("y_size");
    double resolution = CarmenPlaces.finite(config, "resolution");
    if (width <= 0 || height <= 0 || (long) width * height > MOST_CELLS || resolution <= 0) {
      throw new IllegalArgumentException(
          "a map of " + width + " x " + height + " cells of " + resolution + " m is none that can be shown");
    }
    int cells = width * height;
    byte[] data = m.octets("data");
    byte[] plain = m.whole("compressed") != 0 ? Zlib.inflate(data, cells * Float.BYTES) : data;
    if (plain.length != cells * Float.BYTES) {
      throw new IllegalArgumentException(plain.length + " bytes are not those of " + cells + " cells");
    }
    FloatBuffer columns = ByteBuffer.wrap(plain).order(order).asFloatBuffer();
    byte[] rows = new byte[cells];
    for (int x = 0; x < width; x++) {
      for (int y = 0; y < height; y++) {
        rows[y * width + x] = occupancy(columns.get(x * height + y));
      }
    }
    return new GridMap(frame, resolution, width, height, RigidTransform.IDENTITY, Bytes.wrap(rows, 0, rows.length));
  }

  private static byte occupancy(float probability) {
    return probability >= 0 && probability <= 1 ? (byte) Math.round(probability * CERTAIN) : GridMap.UNKNOWN;
  }
}
