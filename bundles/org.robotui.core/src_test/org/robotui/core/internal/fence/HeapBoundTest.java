package org.robotui.core.internal.fence;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class HeapBoundTest {
  private static final long MEGABYTE = 1 << 20;

  @Test
  void theRemedyIsTwiceTheBoundInTheUnitThatOneWouldWrite() {
    assertEquals("ROBOTUI_MEMORY=128m", HeapBound.remedy(64 * MEGABYTE));
    assertEquals("ROBOTUI_MEMORY=1g", HeapBound.remedy(512 * MEGABYTE));
    assertEquals("ROBOTUI_MEMORY=4g", HeapBound.remedy(2048 * MEGABYTE));
    assertEquals("ROBOTUI_MEMORY=3g", HeapBound.remedy(1100 * MEGABYTE));
  }

  @Test
  void aPartOfAMegabyteCountsAsOne() {
    assertEquals(64, HeapBound.megabytes(64 * MEGABYTE - 1));
    assertEquals(64, HeapBound.megabytes(64 * MEGABYTE));
    assertEquals(0, HeapBound.megabytes(0));
  }
}
