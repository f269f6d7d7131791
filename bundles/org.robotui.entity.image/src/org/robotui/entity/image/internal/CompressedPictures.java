package org.robotui.entity.image.internal;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.awt.image.DataBufferUShort;
import java.io.IOException;
import java.util.Iterator;
import java.util.Locale;
import java.util.Set;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.eclipse.swt.graphics.ImageData;
import org.robotui.data.Bytes;
import org.robotui.data.CompressedImage;
import org.robotui.data.PixelEncoding;
import org.robotui.data.RawImage;
import org.robotui.entity.image.Decoding;
import org.robotui.entity.image.Picture;

/** Decodes JPEG and PNG; the header is read, and the size checked, before memory for the pixels is taken. */
public final class CompressedPictures {
  private static final Set<String> FORMATS = Set.of("jpeg", "png");
  private static final String DEPTH = "compressedDepth";
  private static final int DEPTH_HEADER = 12;
  private static final int COLOR_DEPTH = 24;
  private static final int COLOR_BYTES = 3;
  private static final int GREY_DEPTH = 8;

  private CompressedPictures() {}

  /**
   * Decodes.
   *
   * @param image the picture
   * @param limit what is allowed
   * @param refusal says why a size is not
   * @return the picture, or why there is none
   */
  public static Decoding decode(CompressedImage image, Limit limit, Refusal refusal) {
    try (ImageInputStream stream = new MemoryCacheImageInputStream(file(image).stream())) {
      Iterator<ImageReader> readers = ImageIO.getImageReaders(stream);
      while (readers.hasNext()) {
        ImageReader reader = readers.next();
        if (FORMATS.contains(format(reader))) {
          return decode(image, reader, stream, limit, refusal);
        }
      }
      return new Decoding.Undecodable(what(image) + " is neither JPEG nor PNG");
    } catch (IOException | RuntimeException e) {
      // The decoders of the platform answer hostile bytes with all kinds of runtime exceptions.
      return new Decoding.Undecodable(what(image) + " cannot be decoded: " + message(e));
    }
  }

  private static Decoding decode(
      CompressedImage image, ImageReader reader, ImageInputStream stream, Limit limit, Refusal refusal) throws IOException {
    try {
      reader.setInput(stream, true, true);
      int width = reader.getWidth(0);
      int height = reader.getHeight(0);
      return limit.allows(width, height)
          ? new Decoding.Decoded(picture(image, reader.read(0), format(reader)))
          : new Decoding.Undecodable(refusal.of(width, height));
    } finally {
      reader.dispose();
    }
  }

  private static Picture picture(CompressedImage image, BufferedImage decoded, String format) {
    if (decoded.getType() == BufferedImage.TYPE_USHORT_GRAY) {
      RawImage depth = depth(image, decoded);
      return new Picture(RawPictures.pixels(depth), format + " 16 bit", new RawValues(depth));
    }
    return new Picture(pixels(decoded), format, (x, y) -> values(decoded.getRGB(x, y)));
  }

  private static ImageData pixels(BufferedImage decoded) {
    int width = decoded.getWidth();
    int height = decoded.getHeight();
    return switch (decoded.getType()) {
      case BufferedImage.TYPE_3BYTE_BGR ->
          new ImageData(width, height, COLOR_DEPTH, RawPictures.BGR, 1, bytes(decoded));
      case BufferedImage.TYPE_BYTE_GRAY -> new ImageData(width, height, GREY_DEPTH, Greys.palette(), 1, bytes(decoded));
      default -> converted(decoded);
    };
  }

  private static byte[] bytes(BufferedImage decoded) {
    return ((DataBufferByte) decoded.getRaster().getDataBuffer()).getData();
  }

  private static ImageData converted(BufferedImage decoded) {
    int width = decoded.getWidth();
    byte[] target = new byte[width * decoded.getHeight() * COLOR_BYTES];
    int[] row = new int[width];
    for (int y = 0, out = 0; y < decoded.getHeight(); y++) {
      decoded.getRGB(0, y, width, 1, row, 0, width);
      for (int pixel : row) {
        target[out++] = (byte) (pixel >> 16);
        target[out++] = (byte) (pixel >> 8);
        target[out++] = (byte) pixel;
      }
    }
    return new ImageData(width, decoded.getHeight(), COLOR_DEPTH, RawPictures.RGB, 1, target);
  }

  private static RawImage depth(CompressedImage image, BufferedImage decoded) {
    short[] values = ((DataBufferUShort) decoded.getRaster().getDataBuffer()).getData();
    byte[] bytes = new byte[values.length * 2];
    for (int i = 0; i < values.length; i++) {
      bytes[2 * i] = (byte) values[i];
      bytes[2 * i + 1] = (byte) (values[i] >> 8);
    }
    return new RawImage(image.frame(), decoded.getWidth(), decoded.getHeight(), PixelEncoding.U16C1, false,
        2 * decoded.getWidth(), Bytes.wrap(bytes, 0, bytes.length));
  }

  private static String values(int rgb) {
    return (rgb >> 16 & 0xff) + " " + (rgb >> 8 & 0xff) + " " + (rgb & 0xff);
  }

  /** ROS puts a header before the PNG of a depth picture, and the format says so. */
  private static Bytes file(CompressedImage image) {
    Bytes all = image.data();
    if (!image.format().contains(DEPTH) || all.size() < DEPTH_HEADER) {
      return all;
    }
    byte[] rest = new byte[all.size() - DEPTH_HEADER];
    all.copyTo(DEPTH_HEADER, rest, 0, rest.length);
    return Bytes.wrap(rest, 0, rest.length);
  }

  private static String format(ImageReader reader) throws IOException {
    return reader.getFormatName().toLowerCase(Locale.ROOT);
  }

  private static String what(CompressedImage image) {
    return "the picture (format '" + image.format() + "', " + image.data().size() + " bytes)";
  }

  private static String message(Exception e) {
    return e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
  }

  /** What sizes are allowed. */
  @FunctionalInterface
  public interface Limit {
    /**
     * Whether a size is allowed.
     *
     * @param width pixels
     * @param height pixels
     * @return true where it is
     */
    boolean allows(int width, int height);
  }

  /** Says why a size is not allowed. */
  @FunctionalInterface
  public interface Refusal {
    /**
     * The reason.
     *
     * @param width pixels
     * @param height pixels
     * @return a sentence
     */
    String of(int width, int height);
  }
}
