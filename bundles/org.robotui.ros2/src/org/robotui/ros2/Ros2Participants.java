package org.robotui.ros2;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ThreadFactory;
import org.robotui.ros2.internal.context.CountedParticipation;
import org.robotui.rtps.GuidPrefix;
import org.robotui.rtps.ParticipantLimits;

/**
 * Contexts of one process that share participants: those that look for others in the same way are one participant,
 * which is opened with the first of them and closed with the last. Each has its own nodes, types and threads. What one
 * of them receives is taken on the thread of the participant, which is that of all. Safe for all threads.
 */
public final class Ros2Participants {
  private final ThreadFactory threads;
  private final Map<Way, CountedParticipation> ways = new ConcurrentHashMap<>();

  /** How a participant looks for others, and what it gives them. */
  private record Way(int domain, Ros2Environment.Range range, List<String> staticPeers, List<String> interfaces,
      ParticipantLimits limits, Optional<Duration> lease) {
    static Way of(Ros2Environment environment, Ros2Options options) {
      return new Way(environment.domain(), environment.range(), environment.staticPeers(), environment.interfaces(),
          options.limits(), options.lease());
    }
  }

  /**
   * With no participant yet.
   *
   * @param threads makes the threads of all participants, which outlive the context that came first
   */
  public Ros2Participants(ThreadFactory threads) {
    this.threads = threads;
  }

  /**
   * Opens a context. Waits while another thread opens or closes the participant that it shares.
   *
   * @param environment the surroundings
   * @param options what its owner gives it; the threads are those of its own services
   * @return the open context; names of nodes must differ from those of contexts that share its participant
   * @throws IOException if a socket cannot be opened; the message says which and what may help
   */
  public Ros2Context open(Ros2Environment environment, Ros2Options options) throws IOException {
    return ways.computeIfAbsent(Way.of(environment, options), way -> new CountedParticipation(threads))
        .enter(environment, options);
  }

  /**
   * Whether a participant that others see is one of these.
   *
   * @param participant which one
   * @return true while contexts of this process take part by it
   */
  public boolean include(GuidPrefix participant) {
    return ways.values().stream().anyMatch(way -> way.is(participant));
  }
}
