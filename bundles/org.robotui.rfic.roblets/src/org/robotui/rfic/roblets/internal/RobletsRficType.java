package org.robotui.rfic.roblets.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Settings;
import org.robotui.rfic.roblets.internal.call.RobletsPorts;

/** The type {@code roblets}: the roblets that a brain knows by their beacons. */
@Component(service = RficType.class)
public final class RobletsRficType implements RficType {
  /** Streams and commands are those of the roblets; what is of the whole body is always there. */
  private static final Descriptor DESCRIPTOR = new Descriptor("roblets", "Roblets",
      "Roblets with a brain and a bodymap (Robotics4.NET), found by their beacons.", RobletsSettings.SCHEMA,
      List.of(RobletsPorts.BODY, RobletsPorts.SERVICES, RobletsPorts.GRAPH));

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    return RobletsSessions.rfic(context, RobletsSettings.of(settings, System.getenv()));
  }
}
