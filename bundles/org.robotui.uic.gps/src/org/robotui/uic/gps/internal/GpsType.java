package org.robotui.uic.gps.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Arity;
import org.robotui.api.port.StreamPort;
import org.robotui.data.sensor.GpsFix;

/** Receivers of satellite positions on a plane of metres. */
@Component(service = UicType.class)
public final class GpsType implements UicType {
  /** Where positions come from. */
  public static final StreamPort<GpsFix> FIX =
      new StreamPort<>("fix", GpsFix.class, Arity.MANY, "Positions of receivers, of any number of robots.");

  private static final double RATE_HZ = 15;

  private static final Descriptor DESCRIPTOR = new Descriptor("gps", "GPS",
      "Satellite positions on a plain metric grid, with tracks, accuracy and quality; measures and copies coordinates.",
      GpsOptions.schema(), List.of(FIX));

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
    return new GpsUic(context);
  }
}
