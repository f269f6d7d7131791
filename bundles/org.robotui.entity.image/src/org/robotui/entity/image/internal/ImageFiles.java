package org.robotui.entity.image.internal;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferUShort;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Iterator;
import java.util.Locale;
import java.util.Set;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.robotui.data.array.Bytes;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;

/** Reads JPEG and PNG; the header is read, and the size checked, before memory for the pixels is taken. */
final class ImageFiles {
  private static final Set<String> FORMATS = Set.of("jpeg", "png");

  private ImageFiles() {}

  /**
   * What was in a file.
   *
   * @param pixels the picture
   * @param format jpeg or png
   */
  record Decoded(BufferedImage pixels, String format) {}

  static Decoded read(Bytes file) throws IOException {
    PngChunks.check(file);
    try (ImageInputStream stream = new MemoryCacheImageInputStream(file.stream())) {
      Iterator<ImageReader> readers = ImageIO.getImageReaders(stream);
      while (readers.hasNext()) {
        ImageReader reader = readers.next();
        String format = reader.getFormatName().toLowerCase(Locale.ROOT);
        if (FORMATS.contains(format)) {
          return new Decoded(read(reader, stream), format);
        }
      }
      throw new IOException("it is neither JPEG nor PNG");
    }
  }

  /** Grey of 16 bits as what the robot means by it. */
  static RawImage sixteen(CompressedImage image, BufferedImage pixels, PixelEncoding encoding) {
    short[] values = ((DataBufferUShort) pixels.getRaster().getDataBuffer()).getData();
    return raw(image, pixels.getWidth(), pixels.getHeight(), encoding, values);
  }

  static RawImage raw(CompressedImage image, int width, int height, PixelEncoding encoding, short[] values) {
    ByteBuffer bytes = ByteBuffer.allocate(values.length * Short.BYTES).order(ByteOrder.LITTLE_ENDIAN);
    bytes.asShortBuffer().put(values);
    return new RawImage(image.frame(), width, height, encoding, false, Short.BYTES * width, Bytes.wrap(bytes));
  }

  private static BufferedImage read(ImageReader reader, ImageInputStream stream) throws IOException {
    try {
      reader.setInput(stream, true, true);
      TooLargeException.check(reader.getWidth(0), reader.getHeight(0));
      return reader.read(0);
    } finally {
      reader.dispose();
    }
  }
}
