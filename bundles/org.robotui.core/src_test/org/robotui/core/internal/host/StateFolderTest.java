package org.robotui.core.internal.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;
import org.junit.jupiter.api.Test;

class StateFolderTest {
  private final Properties properties = new Properties();

  @Test
  void isThePropertyElseXdgElseHome() {
    properties.setProperty("user.home", "/home/anna");
    assertEquals(Path.of("/home/anna/.local/state/robotui"), StateFolder.of(properties, Map.of()).path());
    assertEquals(Path.of("/x/robotui"), StateFolder.of(properties, Map.of("XDG_STATE_HOME", "/x")).path());
    assertEquals(Path.of("/home/anna/.local/state/robotui"),
        StateFolder.of(properties, Map.of("XDG_STATE_HOME", "relative is invalid")).path());
    properties.setProperty("robotui.state", "/y");
    assertEquals(Path.of("/y"), StateFolder.of(properties, Map.of("XDG_STATE_HOME", "/x")).path());
  }

  @Test
  void filesOfOneNameInTwoFoldersHaveTwoOverlays() {
    StateFolder folder = new StateFolder(Path.of("/y"));
    assertNotEquals(folder.overlay(Path.of("/a/robot.yaml")), folder.overlay(Path.of("/b/robot.yaml")));
    assertEquals(folder.overlay(Path.of("/a/robot.yaml")), folder.overlay(Path.of("/a/../a/robot.yaml")));
  }
}
