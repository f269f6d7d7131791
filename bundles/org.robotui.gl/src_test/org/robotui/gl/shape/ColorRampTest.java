package org.robotui.gl.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class ColorRampTest {
  @Test
  void itEndsWithItsEndsWhateverIsAsked() {
    assertEquals(0x30123b, ColorRamp.TURBO.rgb(-1));
    assertEquals(0x30123b, ColorRamp.TURBO.rgb(0));
    assertEquals(0x7a0403, ColorRamp.TURBO.rgb(7));
    assertEquals(ColorRamp.GREY.rgb(0), ColorRamp.GREY.rgb(Double.NaN));
  }

  @Test
  void aTableCanBeginAtTheOtherEnd() {
    assertEquals(0xffffff, ColorRamp.GREY.table(3, true)[0]);
    assertEquals(0x181818, ColorRamp.GREY.table(3, false)[0]);
  }

  @Test
  void idsNameRamps() {
    assertEquals(List.of("turbo", "viridis", "grey"), ColorRamp.ids());
    assertEquals(ColorRamp.VIRIDIS, ColorRamp.named("viridis"));
  }
}
