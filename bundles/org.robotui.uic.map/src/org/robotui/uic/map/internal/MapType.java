package org.robotui.uic.map.internal;

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
import org.robotui.api.show.Showing;
import org.robotui.data.Data;
import org.robotui.ui.ServiceHandles;
import org.robotui.ui.display.DisplayFaults;
import org.robotui.ui.layer.LayerStack;
import org.robotui.ui.layer.LayerType;

/** The map: what robots know of the floor around them, seen from above. Kinds of layers come and go while it runs. */
@Component(service = UicType.class)
public final class MapType implements UicType {
  private static final double RATE_HZ = 30;

  private static final Descriptor DESCRIPTOR = new Descriptor("map", "Map",
      "Grid maps, scans, sonars, bumpers, paths and robots from above; measures, and sends goals and initial poses.",
      MapOptions.schema(), MapPorts.ALL);

  private final ServiceHandles<LayerType> services;

  @Reference(service = LayerType.class, cardinality = ReferenceCardinality.MULTIPLE, policy = ReferencePolicy.DYNAMIC)
  private volatile List<ServiceReference<LayerType>> kinds = List.of();

  /** Called by declarative services. */
  @Activate
  public MapType(BundleContext bundles) {
    services = new ServiceHandles<>(bundles);
  }

  /** With kinds of layers that do not change. */
  MapType(List<LayerType> given) {
    services = ServiceHandles.of(given);
  }

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Schema choices() {
    return MapOptions.schema(kinds().stream().map(LayerStack::kind).toList());
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
    return List.of(Showing.streams("map", "Show in Map",
        kinds().stream().<Class<? extends Data>>flatMap(kind -> kind.accepts().stream()).distinct().toList()));
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    return new MapUic(context, this::kinds);
  }

  @Override
  public List<SettingFault> faults(Settings settings) {
    return DisplayFaults.of(settings, LayerStack.LAYERS, "layer", kinds().stream().map(LayerStack::kind).toList());
  }

  private List<LayerType> kinds() {
    return services.take(kinds);
  }
}
