package org.robotui.uic.map.internal.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.robotui.ui.Figures;

/** The label of a measure by clicks and by a drag; a point of the world is a pixel here. */
class MeasureToolTest {
  private final MeasureTool tool = new MeasureTool();

  @Test
  void twoClicksMeasure() {
    click(10, 20);
    tool.hover(50, 20);
    assertEquals(words(40, 0), tool.label(), "the second end follows the pointer");
    click(10, 120);
    tool.hover(300, 300);
    assertEquals(words(100, 90), tool.label(), "it stays when both ends are set");
  }

  @Test
  void aHandThatTremblesClicks() {
    tool.down(10, 20);
    tool.drag(12, 20);
    tool.up(12, 21);
    assertTrue(tool.hint().contains("second"), tool.hint());
    tool.down(110, 20);
    tool.drag(112, 21);
    tool.up(110, 20);
    assertEquals(words(100, 0), tool.label());
  }

  @Test
  void aDragMeasures() {
    tool.down(10, 20);
    tool.drag(60, 20);
    tool.up(110, 20);
    tool.hover(300, 300);
    assertEquals(words(100, 0), tool.label());
  }

  @Test
  void aThirdClickBeginsAnew() {
    click(0, 0);
    click(10, 0);
    click(100, 100);
    tool.hover(100, 130);
    assertEquals(words(30, 90), tool.label());
  }

  private static String words(double metres, double degrees) {
    return Figures.of(metres, 2, "m") + "  " + Figures.degrees(Math.toRadians(degrees), 1);
  }

  private void click(double x, double y) {
    tool.down(x, y);
    tool.up(x, y);
  }
}
