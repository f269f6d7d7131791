package org.robotui.uic.teleop.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class StickTest {
  @Test
  void upIsForwardAndLeftIsLeft() {
    assertEquals(new Stick(0.5, 0.25), Stick.ofPointer(-0.25, -0.5));
  }

  @Test
  void staysOnTheDiscInTheSameDirection() {
    Stick stick = Stick.ofPointer(3, -4);
    assertEquals(0.8, stick.forward(), 1e-9);
    assertEquals(-0.6, stick.left(), 1e-9);
  }

  @Test
  void theMiddleIsRest() {
    assertEquals(Stick.REST, Stick.ofPointer(0.02, -0.03));
  }
}
