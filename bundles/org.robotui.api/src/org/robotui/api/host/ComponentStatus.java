package org.robotui.api.host;

import java.util.Optional;
import org.robotui.api.link.LinkState;

/**
 * How a component is doing, at one moment.
 *
 * @param id within its RUIC
 * @param type id of its type
 * @param kind what kind of component
 * @param state its life cycle; FAILED also where its type is not installed
 * @param reason a sentence for users where it failed, else empty
 * @param link the link of a robot interface
 */
public record ComponentStatus(
    String id, String type, Kind kind, RuicState state, String reason, Optional<LinkState> link) {
  /** Kinds of components within a RUIC. */
  public enum Kind {
    /** A robot interface. */
    RFIC,
    /** A view. */
    UIC
  }
}
