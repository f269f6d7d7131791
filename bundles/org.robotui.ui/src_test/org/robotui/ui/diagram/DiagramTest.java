package org.robotui.ui.diagram;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Themes;
import org.robotui.ui.diagram.Wire.Corner;

class DiagramTest {
  private static final Box GROUP = box("g", 0, 0, 300, 100, Box.Form.GROUP);
  private static final Box LEFT = box("a", 10, 30, 80, 28, Box.Form.ROUNDED);
  private static final Box RIGHT = box("b", 200, 30, 80, 28, Box.Form.PILL);
  private static final Wire WIRE = new Wire("a", "b",
      List.of(new Corner(90, 44), new Corner(120, 44), new Corner(200, 44)), "10 Hz", Role.DIM, true);
  private static final Diagram DIAGRAM = new Diagram(List.of(GROUP, LEFT, RIGHT), List.of(WIRE), 300, 100);

  private static Box box(String key, double x, double y, double width, double height, Box.Form form) {
    return new Box(key, x, y, width, height, form, "<" + key + ">", "", Health.NONE, Role.LINE);
  }

  @Test
  void whatLiesInAGroupIsHitBeforeTheGroup() {
    assertEquals(Optional.of(LEFT), DIAGRAM.at(20, 40));
    assertEquals(Optional.of(GROUP), DIAGRAM.at(150, 90));
    assertEquals(Optional.empty(), DIAGRAM.at(301, 50));
  }

  @Test
  void neighboursAreThoseAtTheOtherEndsOfItsWires() {
    assertEquals(Set.of("a", "b"), DIAGRAM.around("b"));
    assertEquals(Set.of("g"), DIAGRAM.around("g"));
  }

  @Test
  void aLabelStandsOnTheLongestPart() {
    assertEquals(new Corner(160, 44), WIRE.middle());
    assertThrows(IllegalArgumentException.class,
        () -> new Wire("a", "b", List.of(new Corner(0, 0)), "", Role.DIM, false));
  }

  @Test
  void allIsSeenUntilItIsMovedAndAZoomKeepsThePlaceUnderThePointer() {
    DiagramEye eye = new DiagramEye();
    eye.settle(DIAGRAM, 182, 500);
    assertEquals(0.85, eye.zoom(), 1e-9, "no smaller than what can be read");
    eye.fit();
    eye.settle(DIAGRAM, 182, 500);
    assertEquals(0.5, eye.zoom(), 1e-9);
    double x = eye.diagramX(50);
    eye.zoom(50, 50, 2);
    assertEquals(x, eye.diagramX(50), 1e-9);
    eye.settle(DIAGRAM, 1000, 1000);
    assertEquals(1, eye.zoom(), 1e-9, "stays as the user left it");
    eye.fit();
    eye.settle(DIAGRAM, 182, 500);
    assertEquals(0.5, eye.zoom(), 1e-9);
  }

  @Test
  void whatDoesNotFitBeginsWithTheFirstBox() {
    Diagram tall = new Diagram(List.of(box("first", 0, 5000, 80, 28, Box.Form.ROUNDED)), List.of(), 80, 10_000);
    DiagramEye eye = new DiagramEye();
    eye.settle(tall, 400, 300);
    assertEquals(5014, eye.diagramY(150), 1);
    Diagram wide = new Diagram(List.of(box("first", 0, 0, 80, 28, Box.Form.ROUNDED)), List.of(), 10_000, 28);
    eye.settle(wide, 400, 300);
    assertEquals(16, eye.left(), 1e-9);
  }

  @Test
  void whatIsOutOfSightIsRevealed() {
    DiagramEye eye = new DiagramEye();
    eye.pan(-1000, 0);
    eye.reveal(RIGHT, 400, 300);
    assertEquals(RIGHT.x() + RIGHT.width() / 2, eye.diagramX(200), 1e-9);
  }

  @Test
  void asSvgNothingOfANameIsMarkup() {
    String svg = DiagramSvg.write(DIAGRAM, Themes.darkPalette());
    assertTrue(svg.contains("&lt;a&gt;") && svg.contains("10 Hz") && svg.contains("stroke-dasharray"), svg);
    assertFalse(svg.contains("<a>"));
  }

  @Test
  void longerWordsAreWider() {
    TextWidths widths = TextWidths.estimate();
    assertTrue(widths.title("/base/odom") > widths.title("/odom"));
    assertTrue(widths.note("/odom") < widths.title("/odom"));
  }
}
