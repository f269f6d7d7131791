package org.robotui.ui.display;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ListedViewTest {
  @Test
  void aNarrowViewHasNoRoomForItsList() {
    assertFalse(ListedView.hasRoom(450));
    assertTrue(ListedView.hasRoom(600));
    assertTrue(ListedView.hasRoom(0), "not yet sized");
  }
}
