package org.robotui.uic.teleop.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.eclipse.swt.graphics.Rectangle;
import org.junit.jupiter.api.Test;

class TeleopLayoutTest {
  @Test
  void liesSideBySideWithAllFiguresWhereThereIsRoom() {
    TeleopLayout at = TeleopLayout.of(500, 290);
    assertTrue(at.stick().x + at.stick().width < at.figures().x);
    assertEquals(4, at.rows());
    assertEquals(2, at.bars());
  }

  @Test
  void liesBelowEachOtherWhereItIsNarrow() {
    TeleopLayout at = TeleopLayout.of(240, 400);
    assertTrue(at.stick().y + at.stick().height < at.figures().y);
  }

  @Test
  void nothingOverlapsOrLeavesTheViewAtAnySize() {
    for (int width = 120; width < 900; width += 17) {
      for (int height = 80; height < 600; height += 13) {
        TeleopLayout at = TeleopLayout.of(width, height);
        String size = width + " x " + height + ": " + at;
        Rectangle body = new Rectangle(0, 0, width, at.footer().y);
        assertEquals(at.stick(), at.stick().intersection(body), size);
        assertFalse(at.stick().intersects(at.figures()), size);
        assertTrue(at.figures().height == 0 || at.figures().intersection(body).equals(at.figures()), size);
      }
    }
  }
}
