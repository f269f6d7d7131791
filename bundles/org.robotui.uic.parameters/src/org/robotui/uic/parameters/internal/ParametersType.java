package org.robotui.uic.parameters.internal;

import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Settings;

/** The parameters of a robot, and the settings of its running programs. */
@Component(service = UicType.class)
public final class ParametersType implements UicType {
  /** As often as a slider that is dragged may send. */
  private static final double RATE_HZ = 20;

  private static final Descriptor DESCRIPTOR = new Descriptor("parameters", "Parameters",
      "Reads and changes the parameters of a robot, and the settings of its programs while they run.",
      ParametersOptions.schema(), ParametersPorts.all());

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
    return new ParametersUic(context);
  }
}
