package org.robotui.uic.teleop.internal;

import java.util.List;
import java.util.stream.Stream;
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
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.StreamPort;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.geometry.Twist;
import org.robotui.data.navigation.NavigationStatus;

/** Drives a mobile base by stick and keys. */
@Component(service = UicType.class)
public final class TeleopType implements UicType {
  static final String MAX_LINEAR = "max_linear";
  static final String MAX_ANGULAR = "max_angular";
  static final String ACCELERATION_LINEAR = "acceleration_linear";
  static final String ACCELERATION_ANGULAR = "acceleration_angular";

  /** Nothing that a person drives by a stick on a screen should be faster. */
  static final double HIGHEST_LINEAR = 1.5;
  static final double HIGHEST_ANGULAR = 3;

  static final CommandPort<VelocityCommand> CMD_VEL =
      new CommandPort<>("cmd_vel", VelocityCommand.class, Arity.ONE, "the base to drive");
  static final StreamPort<Twist> ODOM =
      new StreamPort<>("odom", Twist.class, Arity.OPTIONAL, "how fast the base says it moves");

  static final StreamPort<NavigationStatus> NAVIGATION =
      new StreamPort<>("navigation", NavigationStatus.class, Arity.MANY,
          "whether navigation drives the base to a goal");

  private static final double RATE_HZ = 20;

  private static final Schema SCHEMA = Schema.of(Stream.concat(Stream.of(
      Setting.of(MAX_LINEAR, new ValueType.Num(0, HIGHEST_LINEAR, "m/s"), 0.4,
          "Speed at full stick; navigation has limits of its own."),
      Setting.of(MAX_ANGULAR, new ValueType.Num(0, HIGHEST_ANGULAR, "rad/s"), 1.0,
          "Turning speed at full stick; navigation has limits of its own."),
      Setting.of(ACCELERATION_LINEAR, new ValueType.Num(0.05, 10, "m/s\u00b2"), 1.0,
          "How suddenly the speed may change while the stick is held; letting go always stops at once."),
      Setting.of(ACCELERATION_ANGULAR, new ValueType.Num(0.05, 30, "rad/s\u00b2"), 3.0,
          "How suddenly the turning speed may change while the stick is held.")),
      PadMapping.SETTINGS.stream()).toArray(Setting[]::new));

  private static final Descriptor DESCRIPTOR = new Descriptor("teleop", "Teleop",
      "Drives a mobile base by an on-screen stick or by keys, as long as they are held.",
      SCHEMA, List.of(CMD_VEL, ODOM, NAVIGATION));

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
    Driver driver =
        new Driver(context.output(CMD_VEL), context.input(ODOM), context.input(NAVIGATION), context.principal(),
            context.settings());
    return new TeleopUic(driver, context.settings(), context.background());
  }
}
