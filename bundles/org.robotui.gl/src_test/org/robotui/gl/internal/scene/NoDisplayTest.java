package org.robotui.gl.internal.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIfEnvironmentVariable;
import org.robotui.gl.render.Rendered;

/** What a scene says on a machine without a display. */
@DisabledIfEnvironmentVariable(named = "DISPLAY", matches = ".+", disabledReason = "there is a display")
class NoDisplayTest {
  @Test
  void thereIsNoPictureAndTheReasonAndARemedyAreSaid() throws Exception {
    try (Stage stage = new Stage()) {
      Rendered.Unavailable answer = assertInstanceOf(Rendered.Unavailable.class, stage.rendered(Stage.request()));
      assertTrue(answer.reason().contains("DISPLAY"), answer::reason);
      assertTrue(answer.remedy().contains("xvfb-run"), answer::remedy);
      assertEquals(Optional.empty(), stage.pick(Stage.request(), 1, 1));
    }
  }
}
