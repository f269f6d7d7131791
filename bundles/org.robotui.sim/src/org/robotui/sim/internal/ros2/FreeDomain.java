package org.robotui.sim.internal.ros2;

import java.io.IOException;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.ThreadFactory;
import org.robotui.ros2.Ros2Environment;
import org.robotui.rtps.Participant;
import org.robotui.rtps.ParticipantSettings;

/**
 * Finds a domain in which nobody is on this machine: the ports of the first participant of each domain are its own, so
 * that of two programs that want the same domain at once one gets them.
 */
final class FreeDomain {
  /** Ports of higher domains are among those that Linux gives to any program. */
  private static final int HIGHEST = 101;

  private FreeDomain() {}

  /**
   * Takes part in the first domain that is free, from one that differs from process to process.
   *
   * @param environment all but the domain
   * @throws IOException if there is none
   */
  static Participant enter(Ros2Environment environment, ThreadFactory threads) throws IOException {
    int first = (int) (ProcessHandle.current().pid() % HIGHEST);
    IOException last = new IOException("no domain was tried");
    for (int i = 0; i < HIGHEST; i++) {
      int domain = 1 + (first + i) % HIGHEST;
      try {
        return Participant.open(asFirst(environment.participant(Optional.empty()), domain), threads);
      } catch (IOException e) {
        last = e;
      }
    }
    throw new IOException("no domain of 1 to " + HIGHEST + " is free on this machine: " + last.getMessage(), last);
  }

  private static ParticipantSettings asFirst(ParticipantSettings any, int domain) {
    return new ParticipantSettings(domain, OptionalInt.of(0), any.interfaces(), any.multicast(), any.peers(),
        any.name(), any.userData(), any.lease(), any.announcePeriod(), any.limits());
  }
}
