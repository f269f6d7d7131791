package org.robotui.rfic.recording.internal.report;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Base64;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.Image;
import org.robotui.data.image.RawImage;
import org.robotui.rfic.recording.internal.video.PictureFrame;

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
    return PictureFrame.raw(image, Math.max(1, (image.width() + WIDEST - 1) / WIDEST))
        .map(picture -> address("png", png(picture)));
  }

  private static byte[] png(BufferedImage picture) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    try {
      ImageIO.write(picture, "png", out);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return out.toByteArray();
  }
}
