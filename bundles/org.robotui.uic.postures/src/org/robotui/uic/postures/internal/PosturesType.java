package org.robotui.uic.postures.internal;

import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.uic.postures.internal.model.PostureSequence;

/** Postures of a robot's joints: kept with names, and gone through one after the other. */
@Component(service = UicType.class)
public final class PosturesType implements UicType {
  static final String LOOP = "loop";
  static final String SPEED = "speed";
  static final String PLUGIN = "plugin";
  static final String GUIDE = "guide_plugin";

  private static final double RATE_HZ = 20;
  private static final double LEAST_SPEED = 0.01;
  private static final TextRule NAME = TextRule.matching("the name of a plugin", "\\S+");

  private static final Schema SCHEMA = Schema.of(
      PostureSequence.setting(),
      Setting.of(LOOP, new ValueType.Flag(), false, "Whether the first posture follows the last one."),
      Setting.of(SPEED, new ValueType.Num(LEAST_SPEED, 1, ""), 0.3,
          "How fast joints go at most: a share of the greatest speed of each. A way that would be faster takes longer."),
      Setting.of(PLUGIN, new ValueType.Text(NAME), "JointTrajectory",
          "The plugin of the control that follows trajectories."),
      Setting.of(GUIDE, new ValueType.Text(NAME), "GravityCompensation",
          "The plugin that lets joints be moved by hand."));

  private static final Descriptor DESCRIPTOR = new Descriptor("postures", "Postures",
      "Keeps postures of the joints with names, and has the robot go through them, one after the other.",
      SCHEMA, PosturesPorts.ALL);

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
    return new PosturesUic(context);
  }
}
