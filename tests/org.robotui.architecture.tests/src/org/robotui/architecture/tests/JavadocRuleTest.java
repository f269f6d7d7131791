package org.robotui.architecture.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class JavadocRuleTest {

  private static final String FILE = "org.robotui.data/src/org/robotui/data/Scan.java: ";

  @TempDir
  Path folder;

  @Test
  void accepts_what_is_explained() {
    assertEquals(List.of(), violations(
        "/** A scan. */ public record Scan(int n) { public Scan { } @Override public String toString() { return \"\"; } }"));
  }

  @Test
  void refuses_a_type_a_method_a_constant_and_a_constructor_without_a_comment() {
    assertEquals(
        List.of(FILE + "Scan has no Javadoc", FILE + "N has no Javadoc", FILE + "a constructor has no Javadoc",
            FILE + "turn has no Javadoc"),
        violations(
            "public class Scan { public static final int N = 1; public Scan(int n) { } protected void turn() { } }"));
  }

  @Test
  void refuses_a_method_of_an_interface_without_a_comment() {
    assertEquals(List.of(FILE + "turn has no Javadoc"),
        violations("/** A scan. */ public interface Scan { void turn(); }"));
  }

  @Test
  void does_not_ask_for_what_cannot_be_seen_from_outside() {
    assertEquals(List.of(), violations("class Scan { public void turn() { } }"));
  }

  private List<String> violations(String text) {
    return new Fixture(folder).bundle("org.robotui.data", "Export-Package: org.robotui.data")
        .source("org.robotui.data", "org.robotui.data.Scan", text)
        .violationsOf(new JavadocRule());
  }
}
