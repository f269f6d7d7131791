package org.robotui.rfic.recording.internal.video;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import org.junit.jupiter.api.Test;
import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;
import org.robotui.data.image.CompressedImage;
import org.robotui.data.image.PixelEncoding;
import org.robotui.data.image.RawImage;

class PictureFrameTest {
  private static final FrameId CAMERA = new FrameId("Keira", "camera");

  @Test
  void coloursAreInTheOrderOfScreensAndSizesFit() {
    BufferedImage picture = PictureFrame.of(new RawImage(CAMERA, 2, 1, PixelEncoding.BGR8, false, 6,
        Bytes.of(new byte[]{1, 2, 3, 10, 20, 30}))).orElseThrow();
    assertEquals(0x030201, picture.getRGB(0, 0) & 0xffffff);
    assertEquals(0x1e140a, picture.getRGB(1, 0) & 0xffffff);
    assertEquals(BufferedImage.TYPE_3BYTE_BGR, PictureFrame.sized(picture, 4, 4).getType());
    assertEquals(4, PictureFrame.sized(picture, 4, 4).getHeight());
  }

  @Test
  void whatScreensCannotShowIsNone() {
    assertTrue(PictureFrame.of(new RawImage(CAMERA, 1, 1, PixelEncoding.MONO16, false, 2, Bytes.of(new byte[2])))
        .isEmpty());
    assertTrue(PictureFrame.of(new CompressedImage(CAMERA, "jpeg", Bytes.of(new byte[]{-1, -40, 7}))).isEmpty());
  }
}
