package org.robotui.uic.plot.internal;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Displays;
import org.robotui.testkit.values.ViewTrial;
import org.robotui.uic.plot.internal.model.PlotOptions;

/** Whatever numbers and words a robot sends, the view paints them. */
@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class HostileValuesTest {
  @Test
  void whateverIsSentIsPainted() {
    List<String> signals = List.of("base.Odometry:pose.translation.x", "base.Odometry:linear.x", "base.Battery:voltage",
        "base.JointState:joints[0].position", "derivative(base.Wrench:force.z)", "integral(base.Battery:current)",
        "base.MapRecord:x");
    for (String time : List.of(PlotOptions.BY_RECEIPT, PlotOptions.BY_STAMP)) {
      ViewTrial.of(new PlotType(), context -> {
        context.settings().set(PlotOptions.TIME, time);
        context.settings().set(PlotOptions.AXES,
            List.of(Map.of("traces", signals), Map.of("traces", signals, "x", signals.getFirst())));
      });
    }
  }
}
