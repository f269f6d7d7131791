package org.robotui.uic.plot.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Placed;
import org.robotui.api.config.SettingFault;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Intake;
import org.robotui.api.port.StreamPort;
import org.robotui.api.show.Showing;
import org.robotui.data.Data;
import org.robotui.uic.plot.internal.model.PlotCodec;
import org.robotui.uic.plot.internal.model.PlotOptions;

/** Plots any number of any message over time. */
@Component(service = UicType.class)
public final class PlotType implements UicType {
  static final StreamPort<Data> VALUES = new StreamPort<>(
      "values", Data.class, Arity.MANY, "whatever has numbers; a robot is asked only for what is plotted",
      Intake.CHOSEN);

  private static final double RATE_HZ = 30;

  private static final Descriptor DESCRIPTOR = new Descriptor("plot", "Plot",
      "Plots any number of any message over time, and what is computed of it; measures and exports.",
      PlotOptions.schema(), List.of(VALUES));

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
  public List<Showing> showings() {
    return List.of(Showing.numbers("plot", "Plot"));
  }

  /** Parts that are well each for itself may make no signal together. */
  @Override
  public List<SettingFault> faults(Settings settings) {
    return PlotCodec.faults(settings).stream().map(fault -> Placed.nowhere(fault).fault(fault)).toList();
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    return new PlotUic(context);
  }
}
