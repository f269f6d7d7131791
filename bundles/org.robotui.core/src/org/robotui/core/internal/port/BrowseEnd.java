package org.robotui.core.internal.port;

import java.util.List;
import org.robotui.api.port.BrowseInput;

/** A view's end of a browse port. */
public final class BrowseEnd implements BrowseInput {
  private volatile List<Robot> robots = List.of();

  /** Connects it. */
  public void connect(List<Robot> connected) {
    robots = List.copyOf(connected);
  }

  @Override
  public List<Robot> robots() {
    return robots;
  }
}
