package org.robotui.uic.status.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.port.Arity;
import org.robotui.api.port.StreamPort;
import org.robotui.data.sensor.Battery;

/** Shows how everything of a robot is doing. */
@Component(service = UicType.class)
public final class StatusType implements UicType {
  static final String CONNECTIONS = "connections";
  static final String LOW_CHARGE = "low_charge";

  static final StreamPort<Battery> BATTERY =
      new StreamPort<>("battery", Battery.class, Arity.MANY, "the batteries of the robot");

  private static final double RATE_HZ = 5;

  private static final Schema SCHEMA = Schema.of(
      Setting.of(CONNECTIONS, new ValueType.Flag(), false, "Whether connections are shown in place of ports."),
      Setting.of(LOW_CHARGE, new ValueType.Num(0, 1, ""), 0.25,
          "The fraction of a full battery below which its charge is a warning; below half of it, a fault."));

  private static final Descriptor DESCRIPTOR = new Descriptor("status", "Status",
      "Shows links, batteries and every port of a robot, what is missing and why, and stops the robot.",
      SCHEMA, List.of(BATTERY));

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Surface surface() {
    return Surface.WINDOW;
  }

  @Override
  public double rateHz() {
    return RATE_HZ;
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    return new StatusUic(context);
  }
}
