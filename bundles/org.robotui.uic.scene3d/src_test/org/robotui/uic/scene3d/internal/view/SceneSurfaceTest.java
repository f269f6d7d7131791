package org.robotui.uic.scene3d.internal.view;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class SceneSurfaceTest {
  @Test
  void aNarrowSceneHasNoRoomForItsDisplaysAndSaysOverThePictureWhatTheyWouldSay() {
    assertFalse(SceneSurface.hasRoom(450));
    assertTrue(SceneSurface.hasRoom(600));
    assertTrue(SceneSurface.hasRoom(0), "not yet sized");
  }
}
