package org.robotui.architecture.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PathRuleTest {

  @TempDir
  Path folder;

  private Fixture fixture;

  @BeforeEach
  void fill() {
    fixture = new Fixture(folder).bundle("org.robotui.ros").file("bundles/org.robotui.ros/src/definitions/a.msg", "")
        .file("docs/adr/0007-why.md", "").file("releng/Two words.launch", "").file("rt-native/tests/format.py", "");
  }

  @ParameterizedTest
  @ValueSource(strings = {
      "set(D ${CMAKE_CURRENT_LIST_DIR}/../../bundles/org.robotui.ros/src/definitions)",
      "set(D ${R}/bundles/org.robotui.ros/src/${WHICH}/definitions)",
      "# see docs/adr/0007.",
      "'releng/Two words.launch'",
      "$NATIVE/tests/format.py",
      "rt-native/target/release/bin",
      "bundles/*/target/classes",
      "bundles/org.robotui.gl/lib/jogl-all.jar",
      "$product/robotui"})
  void what_is_there_or_only_known_in_a_run_is_accepted(String text) {
    assertEquals(List.of(), violations("rt-native/cmake/Ros.cmake", text));
  }

  @Test
  void what_was_moved_is_refused() {
    String text = "set(D ${CMAKE_CURRENT_LIST_DIR}/../../bundles/org.robotui.message/src/definitions)";

    assertEquals(
        List.of(
            "rt-native/cmake/Ros.cmake: names bundles/org.robotui.message/src/definitions, which is not there"),
        violations("rt-native/cmake/Ros.cmake", text));
  }

  @ParameterizedTest
  @ValueSource(strings = {"robotui", "tools/build.sh", "tests/e2e/test_x.py", "tests/bench/ui/run",
      "rt-native/ros/CMakeLists.txt"})
  void each_kind_of_file_is_read(String file) {
    assertEquals(List.of(file + ": names docs/adr/0008, which is not there"), violations(file, "# docs/adr/0008"));
  }

  @Test
  void a_path_with_a_variable_in_it_is_there_up_to_the_variable() {
    assertEquals(List.of("tools/x.sh: names bundles/org.robotui.gone/src, which is not there"),
        violations("tools/x.sh", "ls bundles/org.robotui.gone/src/$what"));
  }

  private List<String> violations(String file, String text) {
    return fixture.file(file, text).violationsOf(new PathRule());
  }
}
