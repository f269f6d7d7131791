package org.robotui.api.port;

import java.util.List;

/** The view's end of a browse port. */
public interface BrowseInput {
  /**
   * A robot that can be browsed now.
   *
   * @param source where it is offered
   * @param browser answers; its methods may block
   */
  record Robot(SourceId source, Browser browser) {}

  /**
   * Who can be browsed now.
   *
   * @return the connected ones, in a stable order
   */
  List<Robot> robots();
}
