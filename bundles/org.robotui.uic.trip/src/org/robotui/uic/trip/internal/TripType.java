package org.robotui.uic.trip.internal;

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
import org.robotui.data.navigation.Odometry;

/**
 * The type that configurations name: what it is called, what can be set, which ports it needs, and how an instance is
 * made.
 */
@Component(service = UicType.class)
public final class TripType implements UicType {

  static final String LIMIT = "limit";

  static final StreamPort<Odometry> ODOMETRY =
      new StreamPort<>("odometry", Odometry.class, Arity.MANY, "where the robot says that it is");

  private static final double RATE_HZ = 10;

  private static final Schema SCHEMA = Schema.of(
      Setting.of(LIMIT, new ValueType.Num(0, 1e9, "m"), 1000.0, "A longer trip is shown as a warning."));

  private static final Descriptor DESCRIPTOR =
      new Descriptor("trip", "Trip", "Shows how far a robot has gone.", SCHEMA, List.of(ODOMETRY));

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
    return new TripUic(context);
  }
}
