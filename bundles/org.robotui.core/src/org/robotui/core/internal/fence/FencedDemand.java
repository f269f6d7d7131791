package org.robotui.core.internal.fence;

import org.robotui.api.port.Demand;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A foreign demand that may throw anything without ending the thread that tells it.
 *
 * @param demand the foreign one
 */
public record FencedDemand(Demand demand) implements Demand {
  private static final Logger LOG = LoggerFactory.getLogger(FencedDemand.class);

  @Override
  public void changed(boolean wanted) {
    try {
      demand.changed(wanted);
    } catch (RuntimeException | Error e) { // foreign code may throw anything
      Thrown.log(LOG, "A robot interface failed when told that its stream is " + (wanted ? "wanted" : "not wanted"), e);
    }
  }
}
