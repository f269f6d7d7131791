package org.robotui.architecture.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The rules about the size of sources and what stands in them. */
class SourceRulesTest {

  private static final String FILE = "org.robotui.sim/src/org/robotui/sim/Main.java: ";

  @TempDir
  Path folder;

  @Test
  void a_file_of_400_lines_is_accepted_and_one_of_401_refused() {
    assertEquals(List.of(), violations(new SizeRule(), "\n".repeat(399)));
    assertEquals(List.of(FILE + "401 lines"), violations(new SizeRule(), "\n".repeat(400)));
  }

  @ParameterizedTest
  @ValueSource(strings = {"System.out", "System.err", ".printStackTrace()", "TODO"})
  void what_is_forbidden_is_found(String text) {
    assertEquals(List.of(FILE + "has " + text),
        violations(new ForbiddenTextRule(), "class Main { } // x" + (text.startsWith(".") ? "" : " ") + text));
  }

  @Test
  void an_application_may_print_but_not_put_off() {
    String main = "class Main { public static void main(String[] a) { System.out.println(); } }";

    assertEquals(List.of(), violations(new ForbiddenTextRule(), main));
    assertEquals(List.of(FILE + "has TODO"), violations(new ForbiddenTextRule(), main + "// TODO"));
  }

  private List<String> violations(Rule rule, String text) {
    return new Fixture(folder).bundle("org.robotui.sim").source("org.robotui.sim", "org.robotui.sim.Main", text)
        .violationsOf(rule);
  }
}
