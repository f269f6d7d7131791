package org.robotui.entity.image;

import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.Arrays;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.Image;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;
import org.robotui.testkit.Effort;

/** Bytes that nobody meant well: every answer is a picture or a sentence. */
class HostilePicturesTest {
  private static final FrameId FRAME = new FrameId("Keira", "camera");
  private static final int ROUNDS = 400;

  private final Random random = new Random(11);
  private final PictureDecoder decoder = new PictureDecoder();

  @ParameterizedTest
  @EnumSource(PixelEncoding.class)
  void anyNumbersInAnyRawPictureAreAnAnswer(PixelEncoding encoding) {
    for (Effort effort = Effort.of(ROUNDS / 10, Duration.ofSeconds(10)); effort.goesOn();) {
      int width = 1 + random.nextInt(9);
      int height = 1 + random.nextInt(9);
      int step = width * encoding.bytesPerPixel() + random.nextInt(7);
      byte[] bytes = new byte[step * height + random.nextInt(9)];
      random.nextBytes(bytes);
      RawImage raw = new RawImage(FRAME, width, height, encoding, random.nextBoolean(), step, Bytes.of(bytes));
      answer(raw);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"jpeg", "png", "bayer_rggb8; png compressed ", "mono16; png compressed ",
      "32FC1; compressedDepth png",
      "16UC1; compressedDepth png", "16UC1; compressedDepth rvl", "\u0000;;", ""})
  void mutatedFilesAreAnAnswer(String format) throws IOException {
    byte[] good = good(format);
    for (Effort effort = Effort.of(ROUNDS, Duration.ofSeconds(30)); effort.goesOn();) {
      answer(new CompressedImage(FRAME, format, Bytes.of(mutated(good))));
    }
  }

  @Test
  void aChunkThatSaysMoreThanThereIsIsRefused() throws IOException {
    byte[] png = good("png");
    ByteBuffer.wrap(png).putInt(33, Integer.MAX_VALUE);
    Decoding answer = decoder.decode(new CompressedImage(FRAME, "png", Bytes.of(png)), Rendering.USUAL);
    String reason = ((Decoding.Undecodable) answer).reason();
    assertTrue(reason.contains("a part of 2147483647 bytes"), reason);
  }

  private byte[] mutated(byte[] good) {
    byte[] bytes = random.nextInt(4) == 0 ? Arrays.copyOf(good, random.nextInt(good.length + 20)) : good.clone();
    int changes = random.nextInt(6);
    for (int k = 0; k < changes && bytes.length > 3; k++) {
      int at = random.nextInt(bytes.length - 3);
      switch (random.nextInt(4)) {
        case 0 -> bytes[at] ^= (byte) (1 << random.nextInt(8));
        case 1 -> bytes[at] = (byte) random.nextInt();
        case 2 -> ByteBuffer.wrap(bytes).putInt(at & ~3,
            new int[]{0, -1, Integer.MAX_VALUE, 0x10000}[random.nextInt(4)]);
        default -> System.arraycopy(bytes, random.nextInt(bytes.length - 3), bytes, at, 3);
      }
    }
    return bytes;
  }

  private void answer(Image image) {
    switch (decoder.decode(image, Rendering.USUAL)) {
      case Decoding.Decoded d -> {
        assertNotNull(d.picture().values().at(d.picture().width() - 1, d.picture().height() - 1));
        assertNotNull(d.picture().shrunk(3));
      }
      case Decoding.Undecodable u -> assertNotNull(u.reason());
    }
  }

  private byte[] good(String format) throws IOException {
    if (format.contains("rvl")) {
      ByteBuffer rvl = ByteBuffer.allocate(64).order(ByteOrder.LITTLE_ENDIAN).position(12);
      rvl.putInt(4).putInt(4);
      for (int i = 0; i < 8; i++) {
        rvl.putInt(random.nextInt());
      }
      return rvl.array();
    }
    boolean wide = format.contains("16") || format.contains("32");
    BufferedImage image = new BufferedImage(9, 7, format.contains("bayer") ? BufferedImage.TYPE_BYTE_GRAY
        : wide ? BufferedImage.TYPE_USHORT_GRAY : BufferedImage.TYPE_INT_RGB);
    for (int i = 0; i < 63; i++) {
      image.setRGB(i % 9, i / 9, random.nextInt());
    }
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.writeBytes(new byte[format.contains("compressedDepth") ? 12 : 0]);
    ImageIO.write(image, format.equals("jpeg") ? "jpeg" : "png", out);
    return out.toByteArray();
  }
}
