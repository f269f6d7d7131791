package org.robotui.entity.image.internal;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.robotui.data.PixelEncoding;
import org.robotui.data.RawImage;

/** The numbers of a picture of one channel; NaN where depth was not measured. */
final class Samples {
  private final RawImage raw;
  private final ByteBuffer bytes;

  Samples(RawImage raw) {
    this.raw = raw;
    this.bytes = raw.pixels().buffer(raw.bigEndian() ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
  }

  float at(int x, int y) {
    int at = y * raw.step() + x * raw.encoding().bytesPerPixel();
    return switch (raw.encoding()) {
      case F32C1 -> bytes.getFloat(at);
      case MONO16, U16C1 -> sixteen(bytes.getShort(at) & 0xffff);
      default -> bytes.get(at) & 0xff;
    };
  }

  private float sixteen(int value) {
    return value == 0 && raw.encoding() == PixelEncoding.U16C1 ? Float.NaN : value;
  }
}
