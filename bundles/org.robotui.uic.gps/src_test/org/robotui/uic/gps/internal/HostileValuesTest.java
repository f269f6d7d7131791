package org.robotui.uic.gps.internal;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Displays;
import org.robotui.testkit.values.ViewTrial;
import org.robotui.testkit.values.layer.StrictLayer;

/** Whatever numbers and words a robot sends, the view paints them. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class HostileValuesTest {
  @Test
  void whateverIsSentIsPainted() {
    ViewTrial.of(new GpsType(StrictLayer.of(LayerKinds.ALL)));
  }
}
