package org.robotui.tests.bad;

import org.osgi.framework.BundleActivator;
import org.osgi.framework.BundleContext;
import org.robotui.api.RficType;
import org.robotui.api.UicType;

/** Brings the types, as declarative services do for other bundles. */
public final class BadActivator implements BundleActivator {
  @Override
  public void start(BundleContext context) {
    context.registerService(UicType.class, new BadView(), null);
    context.registerService(RficType.class, new BadRobot(), null);
  }

  @Override
  public void stop(BundleContext context) {
    // The framework withdraws the services.
  }
}
