package org.robotui.sim.internal.ros;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.ros.msgs.dynamic_reconfigure.Config;
import org.robotui.ros.msgs.dynamic_reconfigure.DoubleParameter;
import org.robotui.ros.msgs.dynamic_reconfigure.IntParameter;
import org.robotui.sim.internal.Tuning;
import org.robotui.sim.internal.robot.DriveLimits;

class TuningMessagesTest {
  @Test
  void tuningSurvivesItsMessageAndStaysWithinItsBounds() {
    Tuning tuning = new Tuning(new DriveLimits(0.5, 1.5, 0.6, 2), Tuning.Style.BRISK, false);
    assertEquals(tuning, TuningMessages.merge(Tuning.of(DriveLimits.DEMO), TuningMessages.config(tuning)));
    Config evil = new Config(List.of(), List.of(new IntParameter("driving_style", -7)), List.of(),
        List.of(new DoubleParameter("max_linear_speed", 1e9), new DoubleParameter("max_angular_speed", Double.NaN),
            new DoubleParameter("max_linear_acceleration", -1), new DoubleParameter("unknown", 1)),
        List.of());
    Tuning kept = TuningMessages.merge(tuning, evil);
    assertEquals(new Tuning(new DriveLimits(1.5, 1.5, 0.1, 2), Tuning.Style.CAREFUL, false), kept);
  }
}
