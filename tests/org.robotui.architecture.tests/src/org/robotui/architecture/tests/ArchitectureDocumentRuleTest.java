package org.robotui.architecture.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ArchitectureDocumentRuleTest {

  @TempDir
  Path folder;

  @Test
  void accepts_a_document_that_names_all_bundles() {
    assertEquals(List.of(), violations("`org.robotui.data` holds the records; `org.robotui.uic.*` the views."));
  }

  @Test
  void refuses_a_document_that_leaves_one_out() {
    assertEquals(List.of("ARCHITECTURE.md: does not name the bundle org.robotui.data"),
        violations("org.robotui.data without quotes"));
  }

  @Test
  void refuses_a_document_that_names_one_that_is_gone() {
    assertEquals(List.of("ARCHITECTURE.md: names org.robotui.uic.video, which is no bundle"),
        violations("`org.robotui.data` and `org.robotui.uic.video`"));
  }

  private List<String> violations(String document) {
    return new Fixture(folder).bundle("org.robotui.data").file("ARCHITECTURE.md", document)
        .violationsOf(new ArchitectureDocumentRule());
  }
}
