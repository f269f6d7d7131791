package org.robotui.rfic.player.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class PlayerSettingsTest {
  private static PlayerSettings of(Map<String, Object> written) {
    return PlayerRficCase.settings(written, Map.of());
  }

  @Test
  void theServerIsWrittenOrInTheEnvironmentOrHere() {
    assertEquals("localhost:6665", of(Map.of()).peer());
    assertEquals("robot:6667",
        PlayerRficCase.settings(Map.of(), Map.of("PLAYER_HOST", "robot", "PLAYER_PORT", "6667")).peer());
    assertEquals("keira:6665", PlayerRficCase.settings(Map.of("host", "keira"), Map.of("PLAYER_HOST", "robot")).peer());
    assertEquals("localhost:7000",
        PlayerRficCase.settings(Map.of("port", 7000L), Map.of("PLAYER_PORT", "nonsense")).peer());
  }

  @Test
  void anEnvironmentThatCannotBeIsNamed() {
    for (String port : List.of("nonsense", "0", "70000")) {
      String reason = assertThrows(IllegalArgumentException.class,
          () -> PlayerRficCase.settings(Map.of(), Map.of("PLAYER_PORT", port))).getMessage();
      assertTrue(reason.contains("PLAYER_PORT") && reason.contains(port) && reason.contains("65535"), reason);
    }
    assertThrows(IllegalArgumentException.class, () -> of(Map.of("key", "k".repeat(33))));
  }

  @Test
  void fetchingReplacesUnlessWrittenOtherwise() {
    assertEquals(Optional.empty(), of(Map.of()).pull());
    assertFalse(of(Map.of()).newestOnly());
    assertTrue(of(Map.of("replace", true)).newestOnly());
    assertEquals(Optional.of(Duration.ofMillis(50)), of(Map.of("data", "pull", "rate", 20.0)).pull());
    assertTrue(of(Map.of("data", "pull")).newestOnly());
    assertFalse(of(Map.of("data", "pull", "replace", false)).newestOnly());
  }

  @Test
  void devicesAreChosenByPatterns() {
    assertTrue(of(Map.of()).uses("laser:0"));
    PlayerSettings some = of(Map.of("devices", List.of("laser:*", "position2d:1")));
    assertTrue(some.uses("laser:12") && some.uses("position2d:1"));
    assertFalse(some.uses("position2d:10") || some.uses("sonar:0"));
    assertTrue(of(Map.of("devices", "power:*")).uses("power:0"));
  }
}
