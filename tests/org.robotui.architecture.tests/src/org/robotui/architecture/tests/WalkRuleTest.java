package org.robotui.architecture.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WalkRuleTest {

  @TempDir
  Path folder;

  @Test
  void accepts_methods_that_call_each_other() {
    assertEquals(List.of(), violations("""
        thread of the scanner
          org.robotui.data    Scan.turn       turns
          org.robotui.data      Beam.shine
          org.robotui.data      Beam.fade
        another thread
          org.robotui.data    Beam.fade
        """));
  }

  @Test
  void refuses_a_method_that_is_gone() {
    assertEquals(List.of("ARCHITECTURE.md: a walk leads through org.robotui.data Beam.burn, which does not exist"),
        violations("  org.robotui.data  Beam.burn\n"));
  }

  @Test
  void refuses_a_bundle_that_has_no_such_class() {
    assertEquals(List.of("ARCHITECTURE.md: a walk leads through org.robotui.core Beam.shine, which does not exist"),
        violations("  org.robotui.core  Beam.shine\n"));
  }

  @Test
  void refuses_a_call_that_is_not_made() {
    assertEquals(
        List.of(
            "ARCHITECTURE.md: a walk has org.robotui.data Beam.shine call org.robotui.data Scan.turn, which it does not"),
        violations("""
              org.robotui.data  Beam.shine
              org.robotui.data    Scan.turn
            """));
  }

  @Test
  void refuses_a_line_that_names_no_method() {
    assertEquals(List.of("ARCHITECTURE.md: a walk has a line that names no method: 'and so on'"),
        violations("  org.robotui.data  Beam.shine\n  and so on\n"));
  }

  private List<String> violations(String walk) {
    return new Fixture(folder).bundle("org.robotui.data").bundle("org.robotui.core")
        .source("org.robotui.data", "org.robotui.data.Scan",
            "class Scan { void turn() { beam.shine(); beam.fade(); } }")
        .source("org.robotui.data", "org.robotui.data.Beam", "class Beam { void shine() {} void fade() {} }")
        .file("ARCHITECTURE.md", "# A\n\n```walk\n" + walk + "```\n").violationsOf(new WalkRule());
  }
}
