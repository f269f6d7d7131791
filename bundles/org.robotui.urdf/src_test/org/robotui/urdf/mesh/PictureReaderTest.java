package org.robotui.urdf.mesh;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.urdf.Mutator;

class PictureReaderTest {
  private static Picture read(byte[] bytes) {
    PictureRead read = PictureReader.read(bytes);
    return assertInstanceOf(PictureRead.Ok.class, read, read.toString()).picture();
  }

  private static String refused(byte[] bytes) {
    return assertInstanceOf(PictureRead.Refused.class, PictureReader.read(bytes)).why();
  }

  @Test
  void readsPngAndJpegFromTheTop() {
    Picture png = read(PictureSamples.file("png", 8, 2));
    assertEquals(8, png.width());
    assertEquals(2, png.height());
    assertEquals(0xff0000ff, png.rgba().getInt(0));
    assertEquals(0x0000ff80, png.rgba().getInt(4 * 7));
    Picture jpeg = read(PictureSamples.file("jpeg", 64, 64));
    assertEquals(0xff, jpeg.rgba().get(3) & 0xff);
    assertTrue((jpeg.rgba().get(0) & 0xff) > 200, "red");
  }

  @Test
  void ofALargePictureEveryNthPixelIsTaken() {
    Picture picture = read(PictureSamples.file("png", 2 * Picture.MOST + 2, 3));
    assertEquals((2 * Picture.MOST + 2 + 2) / 3, picture.width());
    assertEquals(1, picture.height());
  }

  @Test
  void refusesWhatIsNoPictureOrTooLargeInWords() {
    assertEquals("it is neither PNG nor JPEG", refused("<svg/>".getBytes(StandardCharsets.UTF_8)));
    assertEquals("it is neither PNG nor JPEG", refused(PictureSamples.file("gif", 4, 4)));
    byte[] png = PictureSamples.file("png", 8, 8);
    assertEquals("it is cut off or broken", refused(Arrays.copyOf(png, png.length - 20)));
    byte[] huge = png.clone();
    ByteBuffer.wrap(huge).putInt(16, 2_000_000_000);
    assertTrue(refused(huge).contains("2000000000 x 8 pixels") || refused(huge).contains("broken"), refused(huge));
  }

  @Test
  void brokenFilesAreRefusedOrReadWhole() {
    Random random = new Random(20261122);
    for (String format : new String[]{"png", "jpeg"}) {
      byte[] sample = PictureSamples.file(format, 16, 16);
      for (int round = 0; round < 400; round++) {
        byte[] broken = Mutator.bytes(sample, random);
        PictureRead read = assertDoesNotThrow(() -> PictureReader.read(broken), format + " round " + round);
        if (read instanceof PictureRead.Ok ok) {
          assertEquals(4 * ok.picture().width() * ok.picture().height(), ok.picture().rgba().remaining());
        }
      }
    }
  }
}
