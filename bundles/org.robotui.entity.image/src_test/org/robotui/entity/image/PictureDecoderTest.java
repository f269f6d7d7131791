package org.robotui.entity.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Random;
import javax.imageio.ImageIO;
import org.eclipse.swt.graphics.RGB;
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
import org.robotui.testkit.Pictures;

class PictureDecoderTest {
  private static final FrameId FRAME = new FrameId("Keira", "camera");

  @Test
  void colourOrdersAreTold() {
    assertEquals(new RGB(10, 20, 30), pixel(Pictures.raw(PixelEncoding.RGB8, 1, 1, b(10, 20, 30)), 0, 0));
    assertEquals(new RGB(30, 20, 10), pixel(Pictures.raw(PixelEncoding.BGR8, 1, 1, b(10, 20, 30)), 0, 0));
    assertEquals(new RGB(10, 20, 30), pixel(Pictures.raw(PixelEncoding.RGBA8, 1, 1, b(10, 20, 30, 255)), 0, 0));
    assertEquals(new RGB(30, 20, 10), pixel(Pictures.raw(PixelEncoding.BGRA8, 1, 1, b(10, 20, 30, 255)), 0, 0));
    assertEquals(new RGB(200, 200, 200), pixel(Pictures.raw(PixelEncoding.MONO8, 1, 1, b(200)), 0, 0));
  }

  @ParameterizedTest
  @EnumSource(PixelEncoding.class)
  void rowsWithPaddingAreRead(PixelEncoding encoding) {
    int step = 2 * encoding.bytesPerPixel() + 5;
    byte[] bytes = new byte[2 * step];
    Arrays.fill(bytes, (byte) 255);
    Arrays.fill(bytes, 0, step - 5, (byte) 60);
    Arrays.fill(bytes, step, 2 * step - 5, (byte) 60);
    RawImage raw = new RawImage(FRAME, 2, 2, encoding, false, step, Bytes.of(bytes));
    for (int i = 1; i < 4; i++) {
      assertEquals(pixel(raw, 0, 0), pixel(raw, i % 2, i / 2), "the padding is no pixel");
      assertEquals(numbers(raw, 0, 0), numbers(raw, i % 2, i / 2));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"RGGB", "BGGR", "GBRG", "GRBG"})
  void anEvenColourBehindABayerFilterIsThatColourEverywhere(String pattern) {
    byte[] bytes = new byte[25];
    for (int i = 0; i < bytes.length; i++) {
      int x = i % 5;
      int y = i / 5;
      bytes[i] = switch (pattern.charAt((y & 1) * 2 + (x & 1))) {
        case 'R' -> (byte) 200;
        case 'G' -> (byte) 100;
        default -> (byte) 50;
      };
    }
    RawImage eight = Pictures.raw(PixelEncoding.valueOf("BAYER_" + pattern + "8"), 5, 5, bytes);
    RawImage sixteen = Pictures.raw(PixelEncoding.valueOf("BAYER_" + pattern + "16"), 5, 5, widened(bytes, 256));
    RawImage twelve = Pictures.raw(PixelEncoding.valueOf("BAYER_" + pattern + "16"), 5, 5, widened(bytes, 16));
    for (int i = 0; i < bytes.length; i++) {
      assertEquals(new RGB(200, 100, 50), pixel(eight, i % 5, i / 5), "pixel " + i);
      assertEquals(new RGB(200, 100, 50), pixel(sixteen, i % 5, i / 5), "pixel " + i);
      assertEquals(new RGB(200, 100, 50), pixel(twelve, i % 5, i / 5), "a sensor of 12 bits is not dark: pixel " + i);
    }
    assertEquals(pattern.charAt(1) + " " + (bytes[1] & 0xff), decoded(eight).values().at(1, 0));
  }

  private static byte[] widened(byte[] bytes, int factor) {
    ByteBuffer wide = ByteBuffer.allocate(2 * bytes.length).order(ByteOrder.LITTLE_ENDIAN);
    for (byte b : bytes) {
      wide.putShort((short) ((b & 0xff) * factor));
    }
    return wide.array();
  }

  @Test
  void aRampBehindABayerFilterStaysARamp() {
    byte[] bytes = new byte[16 * 8];
    for (int i = 0; i < bytes.length; i++) {
      bytes[i] = (byte) (10 * (i % 16));
    }
    RawImage raw = Pictures.raw(PixelEncoding.BAYER_RGGB8, 16, 8, bytes);
    for (int x = 1; x < 15; x++) {
      assertEquals(new RGB(10 * x, 10 * x, 10 * x), pixel(raw, x, 4), "column " + x);
    }
  }

  @Test
  void yuvSharesItsChroma() {
    RawImage uyvy = Pictures.raw(PixelEncoding.UYVY, 2, 1, b(128, 50, 128, 200));
    assertEquals(new RGB(50, 50, 50), pixel(uyvy, 0, 0));
    assertEquals(new RGB(200, 200, 200), pixel(uyvy, 1, 0));
    RawImage red = Pictures.raw(PixelEncoding.YUYV, 2, 1, b(76, 85, 76, 255));
    assertEquals(new RGB(254, 0, 0), pixel(red, 1, 0));
  }

  @Test
  void anOddRowOfYuvIsRead() {
    assertEquals(new RGB(90, 90, 90), pixel(Pictures.raw(PixelEncoding.UYVY, 1, 1, b(128, 90)), 0, 0));
  }

  @Test
  void sixteenBitsOfEitherByteOrderAreRead() {
    RawImage big = new RawImage(FRAME, 2, 1, PixelEncoding.U16C1, true, 4, Bytes.of(b(4, 210, 0, 0)));
    assertEquals("1234 = 1.234\u00a0m", decoded(big).values().at(0, 0));
    assertEquals("0 = no depth", decoded(big).values().at(1, 0));
    assertEquals("1234", decoded(Pictures.raw(PixelEncoding.MONO16, 1, 1, b(210, 4))).values().at(0, 0));
  }

  @Test
  void wideColoursAndThoseWithoutANameAreShown() {
    ByteBuffer rgb = ByteBuffer.allocate(6).order(ByteOrder.LITTLE_ENDIAN);
    rgb.putShort((short) 51200).putShort((short) 25600).putShort((short) 12800);
    assertEquals(new RGB(200, 100, 50), pixel(Pictures.raw(PixelEncoding.RGB16, 1, 1, rgb.array()), 0, 0));
    assertEquals(new RGB(50, 100, 200), pixel(Pictures.raw(PixelEncoding.U16C3, 1, 1, rgb.array()), 0, 0));
    assertEquals(new RGB(50, 100, 200), pixel(Pictures.raw(PixelEncoding.U8C3, 1, 1, b(200, 100, 50)), 0, 0));
    ByteBuffer floats = ByteBuffer.allocate(24).order(ByteOrder.LITTLE_ENDIAN);
    floats.putFloat(0).putFloat(0).putFloat(0).putFloat(0.5f).putFloat(1).putFloat(0);
    RawImage real = Pictures.raw(PixelEncoding.F32C3, 2, 1, floats.array());
    assertEquals(new RGB(0, 255, 128), pixel(real, 1, 0));
    assertEquals("0.50000 1.0000 0.0000", decoded(real).values().at(1, 0));
  }

  @Test
  void greyThatCameThroughABayerFilterIsColouredAgain() throws IOException {
    BufferedImage mosaic = new BufferedImage(6, 6, BufferedImage.TYPE_BYTE_GRAY);
    for (int i = 0; i < 36; i++) {
      mosaic.getRaster().setSample(i % 6, i / 6, 0, (i % 6 + i / 6) % 2 == 1 ? 100 : i / 6 % 2 == 0 ? 200 : 50);
    }
    CompressedImage image = new CompressedImage(FRAME, "bayer_rggb8; png compressed ", Bytes.of(file(mosaic, "png")));
    assertEquals(new RGB(200, 100, 50), decoded(image).color(2, 3));
    assertEquals("bayer_rggb8 png", decoded(image).encoding());
  }

  @Test
  void fromAfarBlocksBecomeTheirMean() {
    Picture picture = decoded(Pictures.raw(PixelEncoding.MONO8, 5, 2, b(0, 10, 20, 30, 70, 0, 10, 20, 30, 70)));
    assertEquals(2, picture.shrunk(2).width);
    assertEquals(5, picture.shrunk(2).getPixel(0, 0));
    assertEquals(40, picture.shrunk(2).getPixel(1, 0));
    assertEquals(1, picture.shrunk(9).width);
    assertEquals(picture.pixels(), picture.shrunk(1));
  }

  @Test
  void picturesAreKeptAsTheyAreSeen() throws IOException {
    Picture picture = decoded(Pictures.room(8, 6));
    Picture again = decoded(new CompressedImage(FRAME, "png", Bytes.of(PicturePng.seen(picture))));
    assertEquals(picture.color(7, 5), again.color(7, 5));
    assertTrue(PicturePng.numbers(picture).isEmpty());
  }

  @Test
  void valuesAreThoseThatWereSent() {
    assertEquals("10 20 30", decoded(Pictures.raw(PixelEncoding.BGR8, 1, 1, b(10, 20, 30))).values().at(0, 0));
  }

  @Test
  void jpegAndPngAreDecoded() throws IOException {
    Picture png = decoded(compressed("png", BufferedImage.TYPE_INT_RGB));
    assertEquals(new RGB(200, 100, 50), png.pixels().palette.getRGB(png.pixels().getPixel(3, 2)));
    assertEquals("200 100 50", png.values().at(3, 2));
    Picture jpeg = decoded(compressed("jpeg", BufferedImage.TYPE_INT_RGB));
    assertEquals("jpeg", jpeg.encoding());
    assertEquals(8, jpeg.width());
    assertEquals(200, jpeg.pixels().palette.getRGB(jpeg.pixels().getPixel(3, 2)).red, 4);
  }

  @Test
  void greyAndTransparentPicturesAreDecoded() throws IOException {
    Picture grey = decoded(compressed("png", BufferedImage.TYPE_BYTE_GRAY));
    assertEquals(8, grey.pixels().depth);
    Picture clear = decoded(compressed("png", BufferedImage.TYPE_INT_ARGB));
    assertEquals("200 100 50", clear.values().at(0, 0));
  }

  @Test
  void aSizeInTheHeaderThatIsTooLargeIsRefusedBeforeMemoryIsTaken() throws IOException {
    byte[] png = file(new BufferedImage(4, 4, BufferedImage.TYPE_INT_RGB), "png");
    ByteBuffer.wrap(png).putInt(16, 60_000).putInt(20, 60_000);
    String reason = refused(new CompressedImage(FRAME, "png", Bytes.of(png)));
    assertTrue(reason.startsWith("the picture is too large (60000\u00d760000)"), reason);
  }

  @Test
  void anEmptyPictureIsRefused() {
    assertEquals("the picture is empty (0\u00d70)",
        refused(new RawImage(FRAME, 0, 0, PixelEncoding.RGB8, false, 0, Bytes.EMPTY)));
  }

  @Test
  void otherFormatsAreNamed() {
    String reason = refused(new CompressedImage(FRAME, "tiff", Bytes.of(b('I', 'I', 42, 0, 8, 0, 0, 0))));
    assertEquals("the picture (format 'tiff', 8 bytes) cannot be decoded: it is neither JPEG nor PNG", reason);
    refused(new CompressedImage(FRAME, "jpeg", Bytes.EMPTY));
    refused(new CompressedImage(FRAME, "16UC1; compressedDepth png", Bytes.of(b(1, 2, 3))));
  }

  @ParameterizedTest
  @ValueSource(strings = {"jpeg", "png"})
  void brokenBytesAreAnAnswerAndNoException(String format) throws IOException {
    byte[] good = file(painted(BufferedImage.TYPE_INT_RGB), format);
    Random random = new Random(7);
    for (int i = 0; i < 600; i++) {
      byte[] bytes = Arrays.copyOf(good, i % 3 == 0 ? random.nextInt(good.length) : good.length);
      for (int k = 0; k < 4 && bytes.length > 0; k++) {
        bytes[random.nextInt(bytes.length)] = (byte) random.nextInt();
      }
      assertInstanceOf(Decoding.class,
          new PictureDecoder().decode(new CompressedImage(FRAME, format, Bytes.of(bytes)), Rendering.USUAL));
    }
    assertTrue(
        refused(new CompressedImage(FRAME, format, Bytes.of(Arrays.copyOf(good, 30)))).contains("'" + format + "'"));
  }

  private static CompressedImage compressed(String format, int type) throws IOException {
    return new CompressedImage(FRAME, format, Bytes.of(file(painted(type), format)));
  }

  private static BufferedImage painted(int type) {
    BufferedImage image = new BufferedImage(8, 6, type);
    for (int i = 0; i < 48; i++) {
      image.setRGB(i % 8, i / 8, 0xffc86432);
    }
    return image;
  }

  private static byte[] file(BufferedImage image, String format) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    assertTrue(ImageIO.write(image, format, out));
    return out.toByteArray();
  }

  /** Without the letters that name a channel. */
  private static String numbers(RawImage raw, int x, int y) {
    return decoded(raw).values().at(x, y).replaceAll("[A-Z]", "");
  }

  private static RGB pixel(RawImage raw, int x, int y) {
    Picture picture = decoded(raw);
    return picture.pixels().palette.getRGB(picture.pixels().getPixel(x, y));
  }

  private static Picture decoded(Image image) {
    return assertInstanceOf(Decoding.Decoded.class, new PictureDecoder().decode(image, Rendering.USUAL)).picture();
  }

  private static String refused(Image image) {
    return assertInstanceOf(Decoding.Undecodable.class, new PictureDecoder().decode(image, Rendering.USUAL)).reason();
  }

  private static byte[] b(int... values) {
    byte[] bytes = new byte[values.length];
    for (int i = 0; i < values.length; i++) {
      bytes[i] = (byte) values[i];
    }
    return bytes;
  }
}
