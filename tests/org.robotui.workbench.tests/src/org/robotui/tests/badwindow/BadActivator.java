package org.robotui.tests.badwindow;

import org.osgi.framework.BundleActivator;
import org.osgi.framework.BundleContext;
import org.robotui.api.UicType;

/** Brings the type, as declarative services do for other bundles. */
public final class BadActivator implements BundleActivator {
  @Override
  public void start(BundleContext context) {
    context.registerService(UicType.class, new BadView(), null);
  }

  @Override
  public void stop(BundleContext context) {
    // The framework withdraws the service.
  }
}
