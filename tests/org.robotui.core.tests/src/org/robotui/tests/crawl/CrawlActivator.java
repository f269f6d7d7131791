package org.robotui.tests.crawl;

import org.osgi.framework.BundleActivator;
import org.osgi.framework.BundleContext;
import org.robotui.api.bridge.BridgeTransform;

/** Brings the transform as long as its bundle runs. */
public final class CrawlActivator implements BundleActivator {
  @Override
  public void start(BundleContext context) {
    context.registerService(BridgeTransform.class, new CrawlTransform(), null);
  }

  @Override
  public void stop(BundleContext context) {
    // the framework withdraws the service
  }
}
