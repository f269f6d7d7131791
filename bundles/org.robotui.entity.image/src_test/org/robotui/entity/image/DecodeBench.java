package org.robotui.entity.image;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Locale;
import javax.imageio.ImageIO;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.Image;
import org.robotui.data.image.PixelEncoding;
import org.robotui.testkit.Pictures;

/**
 * Prints what it costs to decode a picture of 1280 x 720: median and p95 of 100 in milliseconds, and with the
 * shrinking.
 */
final class DecodeBench {
  private static final int WIDTH = 1280;
  private static final int HEIGHT = 720;
  private static final int ROUNDS = 100;

  private DecodeBench() {}

  public static void main(String[] arguments) throws IOException {
    PrintStream out = System.out;
    for (PixelEncoding encoding : new PixelEncoding[]{PixelEncoding.RGB8, PixelEncoding.BGRA8, PixelEncoding.MONO8,
        PixelEncoding.BAYER_RGGB8,
        PixelEncoding.BAYER_GRBG16, PixelEncoding.UYVY, PixelEncoding.U16C1, PixelEncoding.MONO16, PixelEncoding.F32C1,
        PixelEncoding.F32C3}) {
      report(out, encoding.rosName(), Pictures.raw(encoding, WIDTH, HEIGHT, scene(encoding)));
    }
    report(out, "jpeg", file("jpeg", BufferedImage.TYPE_INT_RGB));
    report(out, "16UC1; png", file("16UC1; png compressed", BufferedImage.TYPE_USHORT_GRAY));
  }

  private static byte[] scene(PixelEncoding encoding) {
    ByteBuffer bytes = ByteBuffer.allocate(WIDTH * HEIGHT * encoding.bytesPerPixel()).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; bytes.hasRemaining(); i++) {
      double value = 0.5 + 0.4 * Math.sin(i * 1e-4) + 0.1 * Math.sin(i * 0.01);
      switch (encoding.sample()) {
        case F32 -> bytes.putFloat((float) (6 * value));
        case U16 -> bytes.putShort((short) (6000 * value));
        default -> bytes.put((byte) (255 * value));
      }
    }
    return bytes.array();
  }

  private static Image file(String format, int type) throws IOException {
    BufferedImage image = new BufferedImage(WIDTH, HEIGHT, type);
    byte[] scene = scene(PixelEncoding.U8C1);
    for (int i = 0; i < scene.length; i++) {
      image.setRGB(i % WIDTH, i / WIDTH, (scene[i] & 255) * 0x10101);
    }
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ImageIO.write(image, format.equals("jpeg") ? "jpeg" : "png", out);
    return new CompressedImage(new FrameId("Keira", "camera"), format, Bytes.of(out.toByteArray()));
  }

  private static void report(PrintStream out, String name, Image image) {
    PictureDecoder decoder = new PictureDecoder();
    double[] decode = new double[ROUNDS];
    double[] shrink = new double[ROUNDS];
    for (int i = -ROUNDS; i < ROUNDS; i++) {
      long start = System.nanoTime();
      Picture picture = ((Decoding.Decoded) decoder.decode(image, Rendering.USUAL)).picture();
      long decoded = System.nanoTime();
      picture.shrunk(2);
      if (i >= 0) {
        decode[i] = (decoded - start) * 1e-6;
        shrink[i] = (System.nanoTime() - decoded) * 1e-6;
      }
    }
    Arrays.sort(decode);
    Arrays.sort(shrink);
    out.printf(Locale.ROOT, "%-14s decode %5.1f ms, p95 %5.1f   shrink %4.1f ms%n", name, decode[ROUNDS / 2],
        decode[ROUNDS * 95 / 100],
        shrink[ROUNDS / 2]);
  }
}
