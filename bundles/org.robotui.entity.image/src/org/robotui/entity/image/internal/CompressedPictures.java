package org.robotui.entity.image.internal;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.IOException;
import java.util.Optional;
import org.eclipse.swt.graphics.ImageData;
import org.robotui.data.array.Bytes;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.entity.image.Decoding;
import org.robotui.entity.image.Picture;
import org.robotui.entity.image.Rendering;

/** Decodes JPEG, PNG, and depth as compressed by ROS. */
public final class CompressedPictures {
  private final CompressedImage image;
  private final Format format;
  private final Rendering rendering;
  private final Levels levels;

  private CompressedPictures(CompressedImage image, Rendering rendering, Levels levels) {
    this.image = image;
    this.format = Format.of(image.format());
    this.rendering = rendering;
    this.levels = levels;
  }

  /**
   * Decodes.
   *
   * @param image the picture
   * @param rendering how numbers become colours
   * @param levels what is held from picture to picture
   * @return the picture, or why there is none
   */
  public static Decoding decode(CompressedImage image, Rendering rendering, Levels levels) {
    try {
      return new Decoding.Decoded(new CompressedPictures(image, rendering, levels).picture());
    } catch (TooLargeException e) {
      return new Decoding.Undecodable(e.getMessage());
    } catch (IOException | RuntimeException e) {
      // The decoders of the platform answer hostile bytes with all kinds of runtime exceptions.
      return new Decoding.Undecodable(what(image) + " cannot be decoded: " + message(e));
    }
  }

  private Picture picture() throws IOException {
    if (format.depth()) {
      return numbers(CompressedDepth.decode(image, format), format.rvl() ? "rvl" : "png");
    }
    ImageFiles.Decoded file = ImageFiles.read(image.data());
    return switch (file.pixels().getType()) {
      case BufferedImage.TYPE_USHORT_GRAY -> numbers(
          ImageFiles.sixteen(image, file.pixels(), format.oneChannel(PixelEncoding.U16C1)), file.format());
      case BufferedImage.TYPE_BYTE_GRAY -> grey(file);
      default -> new Picture(color(file.pixels()), file.format(), (x, y) -> values(file.pixels().getRGB(x, y)),
          Optional.empty(), Optional.empty());
    };
  }

  private Picture numbers(RawImage raw, String compression) {
    return named(RawPictures.decode(raw, rendering, levels), raw.encoding().rosName() + " " + compression);
  }

  /** What came through a Bayer filter is compressed as it is, and only the format says so. */
  private Picture grey(ImageFiles.Decoded file) {
    BufferedImage pixels = file.pixels();
    byte[] bytes = ((DataBufferByte) pixels.getRaster().getDataBuffer()).getData();
    PixelEncoding encoding = format.oneChannel(PixelEncoding.MONO8);
    RawImage raw =
        new RawImage(image.frame(), pixels.getWidth(), pixels.getHeight(), encoding, false, pixels.getWidth(),
            Bytes.wrap(bytes, 0, bytes.length));
    String name = encoding == PixelEncoding.MONO8 ? file.format() : encoding.rosName() + " " + file.format();
    return named(RawPictures.decode(raw, rendering, levels), name);
  }

  private static Picture named(Picture picture, String encoding) {
    return new Picture(picture.pixels(), encoding, picture.values(), picture.legend(), picture.numbers());
  }

  private static ImageData color(BufferedImage decoded) {
    int width = decoded.getWidth();
    int height = decoded.getHeight();
    if (decoded.getType() == BufferedImage.TYPE_3BYTE_BGR) {
      byte[] bytes = ((DataBufferByte) decoded.getRaster().getDataBuffer()).getData();
      return new ImageData(width, height, Raster.DEPTH, Colors.bgr(), 1, bytes);
    }
    Raster raster = new Raster(width, height);
    int[] row = new int[width];
    for (int y = 0; y < height; y++) {
      decoded.getRGB(0, y, width, 1, row, 0, width);
      for (int pixel : row) {
        raster.put(pixel);
      }
    }
    return raster.data();
  }

  private static String values(int rgb) {
    return (rgb >> 16 & 0xff) + " " + (rgb >> 8 & 0xff) + " " + (rgb & 0xff);
  }

  private static String what(CompressedImage image) {
    return "the picture (format '" + image.format() + "', " + image.data().size() + " bytes)";
  }

  private static String message(Exception e) {
    return e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage();
  }
}
