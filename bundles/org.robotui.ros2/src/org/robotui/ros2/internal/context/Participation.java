package org.robotui.ros2.internal.context;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import org.robotui.ros2.Ros2Environment;
import org.robotui.ros2.Ros2Options;
import org.robotui.ros2.internal.graph.GraphKeeper;
import org.robotui.rtps.Participant;
import org.robotui.rtps.ParticipantSettings;

/**
 * A participant, and the graph around it with all nodes that are announced by it: one message says them all.
 *
 * @param participant takes part in the domain; closed with this
 * @param graph keeps and announces
 */
record Participation(Participant participant, GraphKeeper graph) implements AutoCloseable {
  /** A participant says three times within its lease that it is there, and a bit more often. */
  private static final int ANNOUNCEMENTS = 4;

  static Participation by(Participant participant) {
    return new Participation(participant, new GraphKeeper(participant));
  }

  static Participation open(Ros2Environment environment, Ros2Options options, ThreadFactory threads)
      throws IOException {
    ParticipantSettings settings = environment.participant(Optional.empty()).withLimits(options.limits());
    if (options.lease().isPresent()) {
      Duration lease = options.lease().get();
      settings = settings.withLease(lease, lease.dividedBy(ANNOUNCEMENTS));
    }
    return by(Participant.open(settings, threads));
  }

  @Override
  public void close() {
    graph.close();
    participant.close();
  }
}
