package org.robotui.rfic.recording.internal.video;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.robotui.data.array.Bytes;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.Image;
import org.robotui.data.image.RawImage;

/** Pictures of cameras in colours that screens have. */
public final class PictureFrame {
  private PictureFrame() {}

  /**
   * A picture of eight bits for each colour, in JPEG or in PNG.
   *
   * @param image as it was sent
   * @return none where it is of another kind, or damaged
   */
  public static Optional<BufferedImage> of(Image image) {
    return switch (image) {
      case CompressedImage packed -> packed(packed);
      case RawImage raw -> raw(raw, 1);
    };
  }

  private static Optional<BufferedImage> packed(CompressedImage image) {
    byte[] data = new byte[image.data().size()];
    image.data().copyTo(0, data, 0, data.length);
    try {
      return Optional.ofNullable(ImageIO.read(new ByteArrayInputStream(data)))
          .map(read -> sized(read, read.getWidth(), read.getHeight()));
    } catch (IOException | RuntimeException e) { // readers of damaged pictures throw any of these
      return Optional.empty();
    }
  }

  /**
   * A picture without compression.
   *
   * @param image as it was sent
   * @param step takes each pixel of so many, in both directions
   * @return none where it does not have eight bits for each colour
   */
  public static Optional<BufferedImage> raw(RawImage image, int step) {
    Optional<int[]> order = switch (image.encoding()) {
      case RGB8, RGBA8, U8C3, U8C4 -> Optional.of(new int[]{0, 1, 2});
      case BGR8, BGRA8 -> Optional.of(new int[]{2, 1, 0});
      case MONO8, U8C1 -> Optional.of(new int[]{0, 0, 0});
      default -> Optional.empty();
    };
    return image.width() == 0 || image.height() == 0 ? Optional.empty()
        : order.map(places -> raw(image, places, step));
  }

  private static BufferedImage raw(RawImage image, int[] order, int step) {
    BufferedImage picture = new BufferedImage((image.width() + step - 1) / step, (image.height() + step - 1) / step,
        BufferedImage.TYPE_3BYTE_BGR);
    Bytes pixels = image.pixels();
    for (int y = 0; y < picture.getHeight(); y++) {
      for (int x = 0; x < picture.getWidth(); x++) {
        int at = y * step * image.step() + x * step * image.encoding().bytesPerPixel();
        picture.setRGB(x, y, pixels.unsigned(at + order[0]) << 16 | pixels.unsigned(at + order[1]) << 8
            | pixels.unsigned(at + order[2]));
      }
    }
    return picture;
  }

  /** Bytes of which three are a pixel, blue first. */
  static BufferedImage of(byte[] bgr, int width, int height) {
    BufferedImage made = new BufferedImage(width, height, BufferedImage.TYPE_3BYTE_BGR);
    byte[] into = ((DataBufferByte) made.getRaster().getDataBuffer()).getData();
    System.arraycopy(bgr, 0, into, 0, into.length);
    return made;
  }

  /** In three bytes for each pixel, and of a size. */
  static BufferedImage sized(BufferedImage picture, int width, int height) {
    boolean same = picture.getWidth() == width && picture.getHeight() == height;
    if (same && picture.getType() == BufferedImage.TYPE_3BYTE_BGR) {
      return picture;
    }
    BufferedImage made = new BufferedImage(width, height, BufferedImage.TYPE_3BYTE_BGR);
    Graphics2D hand = made.createGraphics();
    hand.drawImage(picture, 0, 0, width, height, null);
    hand.dispose();
    return made;
  }
}
