package org.robotui.entity.image;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferUShort;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.RGB;
import org.robotui.data.image.RawImage;
import org.robotui.entity.image.internal.Depth16;

/** Pictures as PNG files. Pure, for any thread but the display thread: it takes long. */
public final class PicturePng {
  private PicturePng() {}

  /**
   * A picture as it is seen.
   *
   * @param picture the picture
   * @return the file's bytes
   * @throws IOException where the platform cannot write it
   */
  public static byte[] seen(Picture picture) throws IOException {
    ImageData pixels = picture.pixels();
    BufferedImage image = new BufferedImage(pixels.width, pixels.height, BufferedImage.TYPE_INT_RGB);
    for (int y = 0; y < pixels.height; y++) {
      for (int x = 0; x < pixels.width; x++) {
        RGB color = picture.color(x, y);
        image.setRGB(x, y, color.red << 16 | color.green << 8 | color.blue);
      }
    }
    return file(image);
  }

  /**
   * The numbers behind the colours, as grey of 16 bits: as they were sent where they have 16 bits, depth in metres as
   * millimetres, where 0 says that nothing was measured.
   *
   * @param picture the picture
   * @return the file's bytes, or none where it has no such numbers
   * @throws IOException where the platform cannot write it
   */
  public static Optional<byte[]> numbers(Picture picture) throws IOException {
    Optional<RawImage> raw = picture.numbers().filter(Depth16::fits);
    if (raw.isEmpty()) {
      return Optional.empty();
    }
    BufferedImage image = new BufferedImage(picture.width(), picture.height(), BufferedImage.TYPE_USHORT_GRAY);
    Depth16.copy(raw.get(), ((DataBufferUShort) image.getRaster().getDataBuffer()).getData());
    return Optional.of(file(image));
  }

  private static byte[] file(BufferedImage image) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    if (!ImageIO.write(image, "png", out)) {
      throw new IOException("there is no writer for PNG");
    }
    return out.toByteArray();
  }
}
