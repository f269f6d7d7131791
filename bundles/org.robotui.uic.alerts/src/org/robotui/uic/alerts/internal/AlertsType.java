package org.robotui.uic.alerts.internal;

import java.time.Clock;
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

/** Lists the alerts of a robot, and mutes and acknowledges them. */
@Component(service = UicType.class)
public final class AlertsType implements UicType {
  static final String SNOOZE = "snooze";

  static final Schema SCHEMA = Schema.of(
      Setting.of(SNOOZE, new ValueType.Num(1, 1440, "min"), 10.0,
          "For how long one press keeps alerts from being heard."));

  private static final double RATE_HZ = 4;
  private static final Descriptor DESCRIPTOR = new Descriptor("alerts", "Alerts",
      "Lists active alerts, since when and why; mutes and acknowledges them.",
      SCHEMA, List.of());

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
    return new AlertsUic(context, Clock.systemDefaultZone());
  }
}
