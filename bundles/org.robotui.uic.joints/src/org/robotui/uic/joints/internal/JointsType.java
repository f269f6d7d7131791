package org.robotui.uic.joints.internal;

import java.util.List;
import java.util.Map;
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
import org.robotui.api.port.Intake;
import org.robotui.api.port.StreamPort;
import org.robotui.data.joint.JointState;

/** Shows the joints of a robot in a table. */
@Component(service = UicType.class)
public final class JointsType implements UicType {
  static final String DEGREES = "degrees";
  static final String UNITS = "units";
  static final String LIMITS = "limits";
  static final String MIN = "min";
  static final String MAX = "max";

  static final StreamPort<JointState> JOINTS =
      new StreamPort<>("joints", JointState.class, Arity.MANY, "the joints of the robot");
  static final StreamPort<JointState> MESSAGES = new StreamPort<>("messages", JointState.class, Arity.MANY,
      "single messages as the robot sends them, now and then, which tell the addresses of values", Intake.CHOSEN);

  private static final double RATE_HZ = 10;
  private static final double FARTHEST = 1e6;

  private static final Schema LIMIT = Schema.of(
      Setting.required(MIN, new ValueType.Num(-FARTHEST, FARTHEST, "rad or m"), "The lowest position."),
      Setting.required(MAX, new ValueType.Num(-FARTHEST, FARTHEST, "rad or m"), "The highest position."));

  private static final Schema SCHEMA = Schema.of(
      Setting.of(DEGREES, new ValueType.Flag(), false, "Whether angles are shown in degrees."),
      Setting.of(UNITS, new ValueType.MapOf(new ValueType.Choice(List.of("rad", "m"))), Map.of(),
          "By joint: rad where it turns, m where it slides. Messages of robots do not say it."),
      Setting.of(LIMITS, new ValueType.MapOf(new ValueType.Section(LIMIT)), Map.of(),
          "By joint: from where to where it moves; without, the range is what was seen."));

  private static final Descriptor DESCRIPTOR = new Descriptor("joints", "Joints",
      "Shows position, velocity and effort of every joint, and which joints have fallen silent.",
      SCHEMA, List.of(JOINTS, MESSAGES));

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
    return new JointsUic(context.input(JOINTS), context.input(MESSAGES), context);
  }
}
