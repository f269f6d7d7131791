package org.robotui.architecture.tests;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.fail;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/** Every rule, on this repository. */
class RepositoryTest {

  private static Repository repository;

  @BeforeAll
  static void readOnce() {
    repository = Repository.at(root());
  }

  @TestFactory
  Stream<DynamicTest> rules() {
    return Rules.ALL.stream().map(rule -> DynamicTest.dynamicTest(rule.statement(), () -> check(rule)));
  }

  @Test
  void the_bundles_are_found() {
    assertFalse(repository.bundles().isEmpty());
  }

  private void check(Rule rule) {
    List<String> broken = rule.violations(repository).map(Violation::toString).distinct().sorted().toList();
    if (!broken.isEmpty()) {
      fail(rule.statement() + ", but:\n  " + String.join("\n  ", broken));
    }
  }

  static Path root() {
    Path folder = Path.of(System.getProperty("robotui.root", "")).toAbsolutePath();
    while (!Files.exists(folder.resolve("bundles/LAYERS"))) {
      folder = folder.getParent();
    }
    return folder;
  }
}
