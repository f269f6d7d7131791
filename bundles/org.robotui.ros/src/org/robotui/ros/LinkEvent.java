package org.robotui.ros;

import org.robotui.net.call.Outcome;

/**
 * A change of one link's state. What becomes of calls to services of other nodes is told by their {@link Outcome}.
 *
 * @param kind what the link is for
 * @param name the topic or service; the node's own name for the master's link
 * @param peer the other side: its node name as soon as it is known, else its address
 * @param state the new state
 */
public record LinkEvent(Kind kind, String name, String peer, LinkState state) {

  /** What a link is for. */
  public enum Kind {
    /** The registration of this node at the master. */
    MASTER,
    /** Messages from a publisher to a subscriber of this node. */
    SUBSCRIPTION,
    /** Messages from a publisher of this node to a subscriber. */
    PUBLICATION,
    /** Calls of a client to a service of this node; reported only when the client is refused or breaks the protocol. */
    SERVICE
  }
}
