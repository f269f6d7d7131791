package org.robotui.uic.plugins.internal;

import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;

/** Starts, stops and reloads the plugins of a control, beside the evidence of how well it keeps its time. */
@Component(service = UicType.class)
public final class PluginsType implements UicType {
  static final String TIMEOUT = "timeout";

  private static final double RATE_HZ = 5;
  private static final double LONGEST_WAIT = 120;

  private static final Schema SCHEMA = Schema.of(
      Setting.of(TIMEOUT, new ValueType.Num(0.1, LONGEST_WAIT, "s"), 10.0,
          "How long the control may take to start, stop or reload a plugin."));

  private static final Descriptor DESCRIPTOR = new Descriptor("plugins", "Plugins",
      "Switches and reloads the plugins of a control, and shows how well its threads keep their time.",
      SCHEMA, PluginsPorts.ALL);

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
    return new PluginsUic(context);
  }
}
