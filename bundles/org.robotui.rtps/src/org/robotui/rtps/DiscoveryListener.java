package org.robotui.rtps;

/**
 * Hears what comes and goes in the domain. All calls come from the receiving thread or the timer of the participant,
 * one after another; they must not block. What one throws is logged, and the rest goes on. Endpoints of a participant
 * are lost before it is lost itself.
 */
public interface DiscoveryListener {

  /**
   * A participant is there.
   *
   * @param participant what it says of itself
   */
  default void participantFound(ParticipantInfo participant) {}

  /**
   * A participant says something else of itself, for example other addresses.
   *
   * @param participant what it says now
   */
  default void participantChanged(ParticipantInfo participant) {}

  /**
   * A participant is gone.
   *
   * @param participant what it said of itself last
   * @param reason for a person to read: it said so, or was not heard for its lease
   */
  default void participantLost(ParticipantInfo participant, String reason) {}

  /**
   * A writer or a reader is there.
   *
   * @param endpoint what its participant says of it
   */
  default void endpointFound(EndpointInfo endpoint) {}

  /**
   * A writer or a reader has changed, for example its QoS.
   *
   * @param endpoint what its participant says of it now
   */
  default void endpointChanged(EndpointInfo endpoint) {}

  /**
   * A writer or a reader is gone.
   *
   * @param endpoint what its participant said of it last
   * @param reason for a person to read
   */
  default void endpointLost(EndpointInfo endpoint, String reason) {}
}
