package org.robotui.entity.image.internal;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferUShort;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.robotui.data.array.Bytes;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;

/**
 * Depth as compressed by ROS: a number of 32 bits and two of floating point, and after them a PNG or RVL of 16 bits.
 * Depth in metres was quantised by its inverse: {@code depth = a / (number - b)}, and 0 says that nothing was measured.
 */
final class CompressedDepth {
  private static final int HEADER = 12;
  private static final int QUANTISER = 4;
  private static final int SIZE = 8;

  private CompressedDepth() {}

  static RawImage decode(CompressedImage image, Format format) throws IOException {
    ByteBuffer header = image.data().buffer(ByteOrder.LITTLE_ENDIAN);
    if (header.remaining() < HEADER) {
      throw new IOException("it is shorter than the header of compressed depth");
    }
    Bytes content = Bytes.wrap(image.data().buffer(ByteOrder.LITTLE_ENDIAN).position(HEADER));
    RawImage numbers = format.rvl() ? rvl(image, content) : png(image, content);
    boolean metres = format.source().filter(s -> s == PixelEncoding.F32C1).isPresent();
    return metres ? metres(numbers, header.getFloat(QUANTISER), header.getFloat(QUANTISER + Float.BYTES)) : numbers;
  }

  private static RawImage png(CompressedImage image, Bytes content) throws IOException {
    BufferedImage pixels = ImageFiles.read(content).pixels();
    if (!(pixels.getRaster().getDataBuffer() instanceof DataBufferUShort) || pixels.getRaster().getNumBands() != 1) {
      throw new IOException("its PNG has not one channel of 16 bits");
    }
    return ImageFiles.sixteen(image, pixels, PixelEncoding.U16C1);
  }

  private static RawImage rvl(CompressedImage image, Bytes content) throws IOException {
    ByteBuffer words = content.buffer(ByteOrder.LITTLE_ENDIAN);
    if (words.remaining() < SIZE) {
      throw new IOException("the data end too early");
    }
    int width = words.getInt();
    int height = words.getInt();
    TooLargeException.check(width, height);
    short[] values = new short[width * height];
    Rvl.decode(words, values);
    return ImageFiles.raw(image, width, height, PixelEncoding.U16C1, values);
  }

  private static RawImage metres(RawImage numbers, float a, float b) {
    ByteBuffer from = numbers.pixels().buffer(ByteOrder.LITTLE_ENDIAN);
    int count = numbers.width() * numbers.height();
    ByteBuffer to = ByteBuffer.allocate(count * Float.BYTES).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < count; i++) {
      int number = from.getShort() & 0xffff;
      to.putFloat(number == 0 ? Float.NaN : a / (number - b));
    }
    return new RawImage(numbers.frame(), numbers.width(), numbers.height(), PixelEncoding.F32C1, false,
        Float.BYTES * numbers.width(), Bytes.wrap(to.flip()));
  }
}
