package org.robotui.entity.image;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.robotui.data.image.PixelEncoding;

class EncodingNamesTest {
  private static final String[] FORMS = {"8U", "8S", "16U", "16S", "32S", "32F", "64F"};

  @ParameterizedTest
  @CsvSource({"rgb8, 3", "rgba8, 4", "rgb16, 6", "rgba16, 8", "bgr8, 3", "bgra8, 4", "bgr16, 6", "bgra16, 8",
      "mono8, 1", "mono16, 2",
      "bayer_rggb8, 1", "bayer_bggr8, 1", "bayer_gbrg8, 1", "bayer_grbg8, 1", "bayer_rggb16, 2", "bayer_bggr16, 2",
      "bayer_gbrg16, 2", "bayer_grbg16, 2", "yuv422, 2", "yuv422_yuy2, 2"})
  void theNamesOfRosAreKnown(String name, int bytes) {
    PixelEncoding encoding = PixelEncoding.fromRos(name).orElseThrow();
    assertEquals(bytes, encoding.bytesPerPixel());
    assertEquals(name, encoding.rosName());
  }

  @Test
  void theAbstractNamesAreKnown() {
    for (String form : FORMS) {
      for (int channels = 1; channels <= 4; channels++) {
        String name = form + "C" + channels;
        PixelEncoding encoding = PixelEncoding.fromRos(name).orElseThrow(() -> new AssertionError(name));
        assertEquals(channels, encoding.channels());
        assertEquals(Integer.parseInt(form.replaceAll("[A-Z]", "")) / 8, encoding.sample().bytes());
        assertEquals(name, encoding.rosName());
      }
    }
    assertTrue(PixelEncoding.fromRos("8UC5").isEmpty());
    assertTrue(PixelEncoding.fromRos("").isEmpty());
  }

  @ParameterizedTest
  @EnumSource(PixelEncoding.class)
  void everyNameFindsItsEncoding(PixelEncoding encoding) {
    assertEquals(encoding, PixelEncoding.fromRos(encoding.rosName()).orElseThrow());
  }
}
