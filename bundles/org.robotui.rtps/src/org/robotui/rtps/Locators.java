package org.robotui.rtps;

import java.util.List;

/**
 * Where a participant or an endpoint hears.
 *
 * @param unicast places of its own
 * @param multicast groups that it joined
 */
public record Locators(List<Locator> unicast, List<Locator> multicast) {

  /** Nowhere that is said. */
  public static final Locators NONE = new Locators(List.of(), List.of());

  /** Copies the lists. */
  public Locators {
    unicast = List.copyOf(unicast);
    multicast = List.copyOf(multicast);
  }

  /**
   * Whether it says nothing.
   *
   * @return true if there is no locator
   */
  public boolean isEmpty() {
    return unicast.isEmpty() && multicast.isEmpty();
  }
}
