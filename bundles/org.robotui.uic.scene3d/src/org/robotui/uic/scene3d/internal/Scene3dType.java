package org.robotui.uic.scene3d.internal;

import java.util.List;
import java.util.Optional;
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
import org.robotui.gl.display.DisplayType;
import org.robotui.gl.render.Gl;
import org.robotui.ui.ServiceHandles;
import org.robotui.ui.display.DisplayFaults;
import org.robotui.uic.scene3d.internal.model.Kinds;

/**
 * The scene in space. Graphics and kinds of displays come and go while it runs; they are taken as handles, so that none
 * of them is started before the first scene is looked at.
 */
@Component(service = UicType.class)
public final class Scene3dType implements UicType {
  private static final double RATE_HZ = 30;

  private static final Descriptor DESCRIPTOR = new Descriptor("scene3d", "Scene",
      "Robots and what they sense in space; measures, selects, sends goals and initial poses.", SceneOptions.schema(),
      ScenePorts.ALL);

  private final ServiceHandles<DisplayType> displays;
  private final ServiceHandles<Gl> renderers;

  @Reference(service = DisplayType.class, cardinality = ReferenceCardinality.MULTIPLE, policy = ReferencePolicy.DYNAMIC)
  private volatile List<ServiceReference<DisplayType>> kinds = List.of();

  @Reference(service = Gl.class, cardinality = ReferenceCardinality.MULTIPLE, policy = ReferencePolicy.DYNAMIC)
  private volatile List<ServiceReference<Gl>> graphics = List.of();

  /** Called by declarative services. */
  @Activate
  public Scene3dType(BundleContext bundles) {
    displays = new ServiceHandles<>(bundles);
    renderers = new ServiceHandles<>(bundles);
  }

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Schema choices() {
    return SceneOptions.schema(Kinds.of(kinds()));
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
    return List.of(
        Showing.streams("display", "Show in Scene",
            kinds().stream().<Class<? extends Data>>flatMap(kind -> kind.accepts().stream()).distinct().toList()),
        Showing.frames("frame", "Show in Scene"));
  }

  @Override
  public List<SettingFault> faults(Settings settings) {
    return DisplayFaults.of(settings, SceneOptions.DISPLAYS, "display", Kinds.of(kinds()));
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    return new Scene3dUic(context, this::kinds, this::graphics);
  }

  private List<DisplayType> kinds() {
    return displays.take(kinds);
  }

  private Optional<Gl> graphics() {
    return renderers.take(graphics).stream().findFirst();
  }
}
