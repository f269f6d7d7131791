package org.robotui.tests.novelty;

import org.osgi.framework.BundleActivator;
import org.osgi.framework.BundleContext;
import org.robotui.api.RficType;
import org.robotui.gl.display.DisplayType;
import org.robotui.ui.layer.LayerType;

/** Brings the types, as declarative services do for other bundles. */
public final class NoveltyActivator implements BundleActivator {
  @Override
  public void start(BundleContext context) {
    context.registerService(LayerType.class, new DepthLayerType(), null);
    context.registerService(DisplayType.class, new DepthDisplayType(), null);
    context.registerService(RficType.class, new BoatType(), null);
  }

  @Override
  public void stop(BundleContext context) {
    // The framework withdraws the services.
  }
}
