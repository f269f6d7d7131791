package org.robotui.gazebo.internal;

import java.util.Optional;

/**
 * A message of discovery.
 *
 * @param version of the protocol
 * @param process who says it
 * @param kind what is said
 * @param topic what is asked for; empty unless somebody asks
 * @param subject what is announced, connected to or ended, if anything
 * @param relayed whether it was sent to one machine, which was to say it again there
 */
record DiscoveryMessage(int version, String process, Kind kind, String topic, Optional<Announcement> subject,
    boolean relayed) {

  /** What is said, in the order of its numbers; the last two came with version 13 of the library. */
  enum Kind {
    NOTHING, ADVERTISE, SUBSCRIBE, UNADVERTISE, HEARTBEAT, BYE, NEW_CONNECTION, END_CONNECTION, SUBSCRIBERS_REQUEST,
    SUBSCRIBERS_REPLY, OTHER
  }

  /** Who may know of it, in the order of its numbers. */
  enum Scope {
    PROCESS, HOST, ALL
  }

  /**
   * A topic or a service of a node.
   *
   * @param topic its full name
   * @param address where it is
   * @param process whose it is
   * @param node which node has it
   * @param scope who may know of it
   * @param ends what is sent there
   */
  record Announcement(String topic, String address, String process, String node, Scope scope, Ends ends) {}

  /** What is sent. */
  sealed interface Ends {
    /** Not said. */
    record Unsaid() implements Ends {}

    /**
     * Messages.
     *
     * @param control the process that is meant, where somebody connects to it
     * @param type of the messages
     */
    record Messages(String control, String type) implements Ends {}

    /**
     * Requests and responses.
     *
     * @param socket the identity of the socket that takes requests
     * @param request the type of requests
     * @param response the type of responses
     */
    record Requests(String socket, String request, String response) implements Ends {}
  }
}
