package org.robotui.gl.internal.splat;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class StarsTest {
  @Test
  void eachPlaceKnowsItsCorners() {
    Stars stars = new Stars(new int[]{2, 0, 3, 0, 3, 2, 9, 9, 9}, 6, 4);
    assertEquals(1, stars.corner(stars.begin(0)));
    assertEquals(3, stars.corner(stars.begin(0) + 1));
    assertEquals(stars.begin(0) + 2, stars.end(0));
    assertEquals(stars.begin(1), stars.end(1), "a place without corners");
    assertEquals(4, stars.corner(stars.end(3) - 1));
  }
}
