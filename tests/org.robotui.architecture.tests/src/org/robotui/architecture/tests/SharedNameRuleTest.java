package org.robotui.architecture.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SharedNameRuleTest {

  @TempDir
  Path folder;

  @Test
  void accepts_a_name_that_a_few_classes_have() {
    assertEquals(List.of(), withClassesNamedRow(SharedNameRule.MOST_CLASSES).violationsOf(new SharedNameRule()));
  }

  @Test
  void refuses_one_that_more_have() {
    List<String> violations = withClassesNamedRow(SharedNameRule.MOST_CLASSES + 1).violationsOf(new SharedNameRule());

    assertEquals(1, violations.size());
    assertEquals("Row: names 6 classes: ", violations.getFirst().substring(0, "Row: names 6 classes: ".length()));
  }

  @Test
  void refuses_more_shared_names_than_there_were() {
    Fixture fixture = new Fixture(folder).bundle("org.robotui.data").bundle("org.robotui.api");
    for (int i = 0; i <= SharedNameRule.MOST_NAMES; i++) {
      fixture.source("org.robotui.data", "org.robotui.data.Row" + i, "").source("org.robotui.api",
          "org.robotui.api.Row" + i, "");
    }

    assertEquals(1, fixture.violationsOf(new SharedNameRule()).size());
  }

  private Fixture withClassesNamedRow(int classes) {
    Fixture fixture = new Fixture(folder);
    for (int i = 0; i < classes; i++) {
      fixture.bundle("org.robotui.uic.v" + i).source("org.robotui.uic.v" + i, "org.robotui.uic.v" + i + ".Row", "");
    }
    return fixture;
  }
}
