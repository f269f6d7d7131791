package org.robotui.urdf.mesh;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Iterator;
import java.util.Locale;
import java.util.Set;
import javax.imageio.ImageIO;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;

/** Reads PNG and JPEG for surfaces. The size is checked before memory for the pixels is taken. */
public final class PictureReader {
  private static final Set<String> FORMATS = Set.of("jpeg", "png");
  private static final long PNG = 0x89504e470d0a1a0aL;
  private static final int PNG_END = 0x49454e44;
  private static final int CHUNK = 12;
  private static final int MOST_BYTES = 64 << 20;
  private static final int MOST_EDGE = 4 * Picture.MOST;

  private PictureReader() {}

  /**
   * Reads a file.
   *
   * @param bytes what is in it
   * @return the picture, or why not
   */
  public static PictureRead read(byte[] bytes) {
    if (bytes.length > MOST_BYTES) {
      return new PictureRead.Refused(
          "it has " + bytes.length + " bytes, more than the " + MOST_BYTES + " that are read");
    }
    if (!isWhole(ByteBuffer.wrap(bytes))) {
      return new PictureRead.Refused("it is cut off or broken");
    }
    try (ImageInputStream stream = new MemoryCacheImageInputStream(new ByteArrayInputStream(bytes))) {
      Iterator<ImageReader> readers = ImageIO.getImageReaders(stream);
      while (readers.hasNext()) {
        ImageReader reader = readers.next();
        if (FORMATS.contains(reader.getFormatName().toLowerCase(Locale.ROOT))) {
          return read(reader, stream);
        }
      }
      return new PictureRead.Refused("it is neither PNG nor JPEG");
    } catch (IOException | RuntimeException e) {
      // decoders answer broken files with all kinds of runtime exceptions
      return new PictureRead.Refused("it is broken: " + e.getMessage());
    }
  }

  /**
   * Whether the chunks of a PNG are as long as they say, as decoders take memory for what they say; other files are.
   */
  private static boolean isWhole(ByteBuffer file) {
    if (file.remaining() < Long.BYTES || file.getLong() != PNG) {
      return true;
    }
    while (file.remaining() >= CHUNK) {
      int length = file.getInt();
      if (length < 0 || length > file.remaining() - 2 * Integer.BYTES) {
        return false;
      }
      if (file.getInt() == PNG_END) {
        return true;
      }
      file.position(file.position() + length + Integer.BYTES);
    }
    return false;
  }

  private static PictureRead read(ImageReader reader, ImageInputStream stream) throws IOException {
    try {
      reader.setInput(stream, true, true);
      int width = reader.getWidth(0);
      int height = reader.getHeight(0);
      if (width > MOST_EDGE || height > MOST_EDGE) {
        return new PictureRead.Refused(
            "it has " + width + " x " + height + " pixels, more than " + MOST_EDGE + " along an edge");
      }
      int every = (Math.max(width, height) + Picture.MOST - 1) / Picture.MOST;
      ImageReadParam sampling = reader.getDefaultReadParam();
      sampling.setSourceSubsampling(every, every, 0, 0);
      return new PictureRead.Ok(picture(reader.read(0, sampling)));
    } finally {
      reader.dispose();
    }
  }

  private static Picture picture(BufferedImage pixels) {
    int width = pixels.getWidth();
    int height = pixels.getHeight();
    ByteBuffer rgba = ByteBuffer.allocate(4 * width * height);
    int[] row = new int[width];
    for (int y = 0; y < height; y++) {
      pixels.getRGB(0, y, width, 1, row, 0, width);
      for (int argb : row) {
        rgba.putInt(Integer.rotateLeft(argb, 8));
      }
    }
    return new Picture(width, height, rgba.flip());
  }
}
