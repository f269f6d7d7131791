package org.robotui.uic.camera.internal;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.RGB;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.entity.image.Decoding;
import org.robotui.entity.image.Picture;
import org.robotui.entity.image.PictureDecoder;
import org.robotui.entity.image.Rendering;
import org.robotui.testkit.Pictures;

/** Makes what cameras see. */
final class Scenes {
  private Scenes() {}

  /** A corridor with a ball, and parts that were not measured; millimetres or metres. */
  static RawImage depth(PixelEncoding encoding, int width, int height) {
    ByteBuffer bytes = ByteBuffer.allocate(width * height * encoding.bytesPerPixel()).order(ByteOrder.LITTLE_ENDIAN);
    for (int y = 0; y < height; y++) {
      for (int x = 0; x < width; x++) {
        double metres = metres((x + 0.5) / width * 2 - 1, ((y + 0.5) / height * 2 - 1) * height / width);
        if (encoding == PixelEncoding.F32C1) {
          bytes.putFloat(metres > 0 ? (float) metres : Float.NaN);
        } else {
          bytes.putShort((short) (1000 * metres));
        }
      }
    }
    return Pictures.raw(encoding, width, height, bytes.array());
  }

  private static double metres(double x, double y) {
    double wall = Math.min(1.2 / Math.abs(x), Math.min(0.55 / Math.abs(y), 6));
    double ball = Math.hypot(x - 0.25, y - 0.12);
    if (ball < 0.16) {
      return 1.6 - Math.sqrt(0.0256 - ball * ball);
    }
    boolean shadow = Math.hypot(x - 0.22, y - 0.12) < 0.175 && x < 0.25;
    boolean window = Math.abs(x + 0.05) < 0.06 && Math.abs(y + 0.03) < 0.05;
    return shadow || window ? 0 : wall;
  }

  /** What a sensor behind a Bayer filter (rggb) makes of a file. */
  static RawImage bayer(byte[] file) {
    Picture picture = ((Decoding.Decoded) new PictureDecoder().decode(
        new CompressedImage(new FrameId("Keira", "left_optical"), "jpeg", Bytes.of(file)), Rendering.USUAL)).picture();
    ImageData pixels = picture.pixels();
    byte[] mosaic = new byte[pixels.width * pixels.height];
    for (int i = 0; i < mosaic.length; i++) {
      int x = i % pixels.width;
      int y = i / pixels.width;
      RGB color = picture.color(x, y);
      mosaic[i] = (byte) ((x + y & 1) == 1 ? color.green : (y & 1) == 0 ? color.red : color.blue);
    }
    return Pictures.raw(PixelEncoding.BAYER_RGGB8, pixels.width, pixels.height, mosaic);
  }
}
