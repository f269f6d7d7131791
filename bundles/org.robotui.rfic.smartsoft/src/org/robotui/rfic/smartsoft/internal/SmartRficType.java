package org.robotui.rfic.smartsoft.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Settings;
import org.robotui.guard.Guards;
import org.robotui.rfic.smartsoft.internal.call.SmartPorts;

/** The type {@code smartsoft}: a client of components that a naming service of ACE/SmartSoft knows. */
@Component(service = RficType.class)
public final class SmartRficType implements RficType {
  /** Streams and commands are those of the components that run; only calling and browsing are always there. */
  private static final Descriptor DESCRIPTOR = new Descriptor("smartsoft", "SmartSoft",
      "Services of SmartSoft's components over ACE, found by asking their naming service which there are.",
      SmartSettings.SCHEMA, List.of(SmartPorts.SERVICES, SmartPorts.GRAPH));

  private final Guards guards = new Guards();

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    return SmartSessions.rfic(context, SmartSettings.of(settings, System.getenv()), guards);
  }
}
