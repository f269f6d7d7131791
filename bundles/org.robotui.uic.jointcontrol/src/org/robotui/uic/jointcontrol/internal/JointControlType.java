package org.robotui.uic.jointcontrol.internal;

import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;

/** Shows how a control drives the joints of a robot, and lets a user who has taken control drive them. */
@Component(service = UicType.class)
public final class JointControlType implements UicType {
  static final String DEGREES = "degrees";
  static final String SPEED = "speed";

  private static final double RATE_HZ = 20;
  private static final double LEAST_SPEED = 0.01;

  private static final Schema SCHEMA = Schema.of(
      Setting.of(DEGREES, new ValueType.Flag(), true, "Whether angles are shown and typed in degrees."),
      Setting.of(SPEED, new ValueType.Num(LEAST_SPEED, 1, ""), 0.2,
          "How fast the view moves a joint at most: a share of the greatest speed of that joint."));

  private static final Descriptor DESCRIPTOR = new Descriptor("jointcontrol", "Joint control",
      "Shows measured and commanded joints with limits, modes, owners and faults, and drives them once control is taken.",
      SCHEMA, JointControlPorts.ALL);

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
    return new JointControlUic(context);
  }
}
