package org.robotui.rtps;

import java.util.List;

/**
 * Two ends of one topic that do not fit.
 *
 * @param remote the other end
 * @param reasons why not, each a sentence for a user to read
 */
public record Mismatch(EndpointInfo remote, List<String> reasons) {

  /** Keeps a list of its own. */
  public Mismatch {
    reasons = List.copyOf(reasons);
  }
}
