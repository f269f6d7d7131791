package org.robotui.uic.postures.internal;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Displays;
import org.robotui.testkit.values.ViewTrial;

/** Whatever numbers and words a robot sends, the view paints them. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class HostileValuesTest {

  @Test
  void whateverIsSentIsPainted() {
    ViewTrial.of(new PosturesType());
  }
}
