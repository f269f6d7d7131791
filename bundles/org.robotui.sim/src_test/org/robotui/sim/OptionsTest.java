package org.robotui.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;

class OptionsTest {
  @Test
  void withoutArgumentsAFreePortAndNoNamespaceAreUsed() {
    Options options = Options.parse(List.of());
    assertEquals(0, options.port());
    assertEquals("", options.namespace());
    assertEquals(OptionalLong.empty(), options.parent());
    assertEquals(1, options.speedFactor());
  }

  @Test
  void everyOptionIsRead() {
    Options options = Options.parse(List.of(
        "--port", "11311", "--namespace", "/keira/", "--name", "base", "--seed", "-7", "--speed-factor", "2.5",
        "--real-master", "http://localhost:11311", "--sim-time", "--parent", "4711", "--swarm", "12", "plan:=/move_base/plan"));
    assertEquals(
        new Options(
            11311, "keira", "base", -7, 2.5, Optional.of(URI.create("http://localhost:11311")), true,
            OptionalLong.of(4711), 12, List.of("plan:=/move_base/plan")),
        options);
  }

  @Test
  void mistakesAreNamed() {
    assertMistake("--port", "--port");
    assertMistake("0 to 65535", "--port", "70000");
    assertMistake("'fast'", "--speed-factor", "fast");
    assertMistake("0.01 to 50", "--speed-factor", "0");
    assertMistake("http", "--real-master", "localhost:11311");
    assertMistake("'--colour'", "--colour", "red");
    assertMistake("'stray'", "stray");
  }

  private static void assertMistake(String named, String... arguments) {
    String message =
        assertThrows(IllegalArgumentException.class, () -> Options.parse(List.of(arguments))).getMessage();
    assertTrue(message.contains(named), message);
  }
}
