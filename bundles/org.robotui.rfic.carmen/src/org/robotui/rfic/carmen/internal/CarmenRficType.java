package org.robotui.rfic.carmen.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Settings;
import org.robotui.guard.Guards;
import org.robotui.rfic.carmen.internal.call.CarmenPorts;

/** The type {@code carmen}: a module at a central of CARMEN. */
@Component(service = RficType.class)
public final class CarmenRficType implements RficType {
  /** Streams and commands are those of the programs that run; only calling and browsing are always there. */
  private static final Descriptor DESCRIPTOR = new Descriptor("carmen", "CARMEN",
      "Messages of CARMEN's programs, found by asking their central which there are.",
      CarmenSettings.SCHEMA, List.of(CarmenPorts.SERVICES, CarmenPorts.GRAPH));

  private final Guards guards = new Guards();

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    return CarmenSessions.rfic(context, CarmenSettings.of(settings, System.getenv()), guards);
  }
}
