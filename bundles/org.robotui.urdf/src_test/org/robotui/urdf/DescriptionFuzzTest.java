package org.robotui.urdf;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Whatever text comes, the answer is a tree, or words. */
class DescriptionFuzzTest {
  private static final int ROUNDS = 4000;

  @Test
  void brokenModelsAreRefusedInWordsOrMakeATree() {
    Random random = new Random(20261122);
    for (int round = 0; round < ROUNDS; round++) {
      String broken = Mutator.text(Samples.ARM, random);
      Parsed<RobotModel> read = assertDoesNotThrow(() -> Urdf.parse(broken), broken);
      if (read instanceof Parsed.Refused<RobotModel>(Problem problem)) {
        assertFalse(problem.message().isBlank());
      }
      read.found().ifPresent(
          model -> assertEquals(model.links().size(), new Kinematics(model).rootFromLinks(Map.of(), Map.of()).size()));
    }
  }

  @Test
  void brokenSemanticsAreRefusedInWordsOrRead() {
    Random random = new Random(20261123);
    RobotModel arm = UrdfTest.arm();
    for (int round = 0; round < ROUNDS; round++) {
      String broken = Mutator.text(Samples.SEMANTICS, random);
      assertDoesNotThrow(() -> Srdf.parse(broken, arm), broken);
    }
  }
}
