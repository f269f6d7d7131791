package org.robotui.uic.gps.internal;

import java.util.List;
import org.osgi.framework.BundleContext;
import org.osgi.framework.ServiceReference;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Reference;
import org.osgi.service.component.annotations.ReferenceCardinality;
import org.osgi.service.component.annotations.ReferencePolicy;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.SettingFault;
import org.robotui.api.config.Settings;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Intake;
import org.robotui.api.port.StreamPort;
import org.robotui.data.Data;
import org.robotui.data.sensor.GpsFix;
import org.robotui.ui.ServiceHandles;
import org.robotui.ui.display.DisplayFaults;
import org.robotui.ui.layer.LayerStack;
import org.robotui.ui.layer.LayerType;

/** Receivers of satellite positions on a plane of metres. */
@Component(service = UicType.class)
public final class GpsType implements UicType {
  /** Where positions come from. */
  public static final StreamPort<GpsFix> FIX =
      new StreamPort<>("fix", GpsFix.class, Arity.MANY, "Positions of receivers, of any number of robots.");

  /** Where whatever else lies on the earth comes from. */
  public static final StreamPort<Data> DATA =
      new StreamPort<>("data", Data.class, Arity.MANY,
          "Whatever else there are layers for; a robot is asked only for what is shown.", Intake.CHOSEN);

  private static final double RATE_HZ = 15;

  private static final Descriptor DESCRIPTOR = new Descriptor("gps", "GPS",
      "Satellite positions on a plain metric grid, with tracks, accuracy and quality; measures and copies coordinates.",
      GpsOptions.schema(), List.of(FIX, DATA));

  private final ServiceHandles<LayerType> services;

  @Reference(service = LayerType.class, cardinality = ReferenceCardinality.MULTIPLE, policy = ReferencePolicy.DYNAMIC)
  private volatile List<ServiceReference<LayerType>> kinds = List.of();

  /** Called by declarative services. */
  @Activate
  public GpsType(BundleContext bundles) {
    services = new ServiceHandles<>(bundles);
  }

  /** With kinds of layers that do not change. */
  GpsType(List<LayerType> given) {
    services = ServiceHandles.of(given);
  }

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Schema choices() {
    return GpsOptions.schema(kinds().stream().map(LayerStack::kind).toList());
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
    return new GpsUic(context, this::kinds);
  }

  @Override
  public List<SettingFault> faults(Settings settings) {
    return DisplayFaults.of(settings, LayerStack.LAYERS, "layer", kinds().stream().map(LayerStack::kind).toList());
  }

  private List<LayerType> kinds() {
    return services.take(kinds);
  }
}
