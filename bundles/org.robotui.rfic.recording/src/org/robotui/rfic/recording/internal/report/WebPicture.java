package org.robotui.rfic.recording.internal.report;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Base64;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.robotui.data.array.Bytes;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.Image;
import org.robotui.data.image.RawImage;

/** Pictures as browsers show them, within a page. */
final class WebPicture {
  /** Wider ones are written with every second, third, ... pixel. */
  private static final int WIDEST = 640;
  private static final int MOST_BYTES = 4 << 20;

  private WebPicture() {}

  /** The address of a picture that holds the picture itself; none where browsers cannot show it. */
  static Optional<String> address(Image image) {
    return switch (image) {
      case CompressedImage packed -> packed(packed);
      case RawImage raw -> raw(raw);
    };
  }

  private static Optional<String> packed(CompressedImage image) {
    int size = image.data().size();
    if (size > MOST_BYTES || size < 4) {
      return Optional.empty();
    }
    byte[] data = new byte[size];
    image.data().copyTo(0, data, 0, size);
    boolean jpeg = image.data().unsigned(0) == 0xff && image.data().unsigned(1) == 0xd8;
    boolean png = image.data().unsigned(0) == 0x89 && data[1] == 'P' && data[2] == 'N' && data[3] == 'G';
    return jpeg ? Optional.of(address("jpeg", data)) : png ? Optional.of(address("png", data)) : Optional.empty();
  }

  private static String address(String kind, byte[] data) {
    return "data:image/" + kind + ";base64," + Base64.getEncoder().encodeToString(data);
  }

  private static Optional<String> raw(RawImage image) {
    Optional<int[]> order = switch (image.encoding()) {
      case RGB8, RGBA8, U8C3, U8C4 -> Optional.of(new int[]{0, 1, 2});
      case BGR8, BGRA8 -> Optional.of(new int[]{2, 1, 0});
      case MONO8, U8C1 -> Optional.of(new int[]{0, 0, 0});
      default -> Optional.empty();
    };
    return image.width() == 0 || image.height() == 0 ? Optional.empty()
        : order.map(places -> address("png", png(image, places)));
  }

  private static byte[] png(RawImage image, int[] order) {
    int step = Math.max(1, (image.width() + WIDEST - 1) / WIDEST);
    BufferedImage picture = new BufferedImage((image.width() + step - 1) / step, (image.height() + step - 1) / step,
        BufferedImage.TYPE_INT_RGB);
    Bytes pixels = image.pixels();
    for (int y = 0; y < picture.getHeight(); y++) {
      for (int x = 0; x < picture.getWidth(); x++) {
        int at = y * step * image.step() + x * step * image.encoding().bytesPerPixel();
        picture.setRGB(x, y, pixels.unsigned(at + order[0]) << 16 | pixels.unsigned(at + order[1]) << 8
            | pixels.unsigned(at + order[2]));
      }
    }
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try {
      ImageIO.write(picture, "png", out);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return out.toByteArray();
  }
}
