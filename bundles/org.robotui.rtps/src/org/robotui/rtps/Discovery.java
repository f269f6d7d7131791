package org.robotui.rtps;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;

/** Who else is in the domain. Safe for all threads. */
public interface Discovery {

  /**
   * The participants that are there, without this one.
   *
   * @return as of now
   */
  List<ParticipantInfo> participants();

  /**
   * One of them.
   *
   * @param prefix whose
   * @return it, if it is there
   */
  Optional<ParticipantInfo> participant(GuidPrefix prefix);

  /**
   * When anything came from one of them last: data, acknowledgements, or that it is there.
   *
   * @param prefix whose
   * @return {@link System#nanoTime()} of that moment; empty if it is not there
   */
  OptionalLong heardNanos(GuidPrefix prefix);

  /**
   * The readers and writers of the other participants, without the built-in ones.
   *
   * @return as of now
   */
  List<EndpointInfo> endpoints();

  /**
   * Adds a listener; it is told first, on this thread, of what is there already, and may hear of something new more
   * than once.
   *
   * @param listener hears of participants and endpoints until it is removed or the participant is closed
   */
  void addListener(DiscoveryListener listener);

  /**
   * Removes a listener.
   *
   * @param listener it hears at most of what is just happening
   */
  void removeListener(DiscoveryListener listener);
}
