package org.robotui.uic.joints.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.InputState;
import org.robotui.data.joint.JointState;
import org.robotui.data.joint.JointState.Joint;
import org.robotui.testkit.FakeInput;
import org.robotui.testkit.FakeUicContext;
import org.robotui.ui.ViewAction;
import org.robotui.uic.joints.internal.model.JointOptions;
import org.robotui.uic.joints.internal.model.JointUnit;
import org.robotui.uic.joints.internal.model.Span;

class JointsUicTest {
  private final FakeUicContext context = new FakeUicContext("joints", new JointsType().schema());
  private final FakeInput<JointState> input = context.input(JointsType.JOINTS);
  private final JointsUic uic = new JointsUic(input, context.input(JointsType.MESSAGES), context);

  @Test
  void aTickTellsNews() {
    assertFalse(uic.tick(0));
    input.put(Gallery.ARM, new JointState(List.of(new Joint("shoulder", 1, 0, 0))), 0, Optional.empty());
    assertTrue(uic.tick(0));
    assertFalse(uic.tick(0));
    input.state(new InputState.Stale(3, "silent"));
    assertTrue(uic.tick(0));
  }

  @Test
  void theChoiceOfDegreesIsKept() {
    ViewAction degrees = uic.actions().getFirst();
    assertFalse(degrees.checked().orElseThrow().getAsBoolean());
    degrees.run().run();
    assertTrue(degrees.checked().orElseThrow().getAsBoolean());
    assertTrue(context.settings().current().flag(JointsType.DEGREES));
  }

  @Test
  void unitsAndLimitsAreRead() {
    assertEquals(JointOptions.NONE, OptionsReader.read(context.settings().current()));
    Gallery.configured(context);
    JointOptions options = OptionsReader.read(context.settings().current());
    assertEquals(JointUnit.METRES, options.unit("lift_joint"));
    assertEquals(JointUnit.RADIANS, options.unit("elbow_joint"));
    assertEquals(JointUnit.UNKNOWN, options.unit("other"));
    assertEquals(Optional.of(new Span(-1, 1, true)), options.limits("elbow_joint"));
  }
}
