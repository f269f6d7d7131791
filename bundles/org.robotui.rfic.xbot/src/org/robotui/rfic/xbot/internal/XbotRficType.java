package org.robotui.rfic.xbot.internal;

import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Settings;

/** The type {@code xbot}: a client of the real-time control of this machine. */
@Component(service = RficType.class)
public final class XbotRficType implements RficType {
  private static final Descriptor DESCRIPTOR = new Descriptor("xbot", "Real-time control",
      "Joints, sensors, plugins and timing of a control that robotui-rt runs on this machine, read from its memory.",
      XbotSettings.SCHEMA, XbotPorts.ALL);

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    return XbotSessions.rfic(context, XbotSettings.of(settings, context.robot()));
  }
}
