package org.robotui.ros2.internal.context;

import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import org.robotui.ros2.Ros2Context;
import org.robotui.ros2.Ros2Environment;
import org.robotui.ros2.Ros2Options;
import org.robotui.rtps.GuidPrefix;

/**
 * A participant that is there while somebody takes part by it. Who enters waits while it is opened or closed for
 * another one, which may take the time of looking up a machine's name. Safe for several threads.
 */
public final class CountedParticipation {
  private final ThreadFactory threads;
  private Optional<Participation> open = Optional.empty();
  private int users;
  private volatile Optional<GuidPrefix> self = Optional.empty();

  /**
   * Not there yet.
   *
   * @param threads makes the threads of the participant
   */
  public CountedParticipation(ThreadFactory threads) {
    this.threads = threads;
  }

  /**
   * Takes part until the context is closed.
   *
   * @param environment the surroundings, the same for all as far as the participant is concerned
   * @param options what the owner of the context gives it
   * @return the open context
   * @throws IOException if a socket cannot be opened
   */
  public synchronized Ros2Context enter(Ros2Environment environment, Ros2Options options) throws IOException {
    if (open.isEmpty()) {
      Participation opened = Participation.open(environment, options, threads);
      open = Optional.of(opened);
      self = Optional.of(opened.participant().info().guid().prefix());
    }
    ContextRuntime context = new ContextRuntime(open.get(), this::leave, environment, options);
    users++;
    return context;
  }

  private synchronized void leave() {
    users--;
    if (users == 0) {
      open.ifPresent(Participation::close);
      open = Optional.empty();
      self = Optional.empty();
    }
  }

  /**
   * Whether it is there and this one.
   *
   * @param participant which one
   * @return true where it is; does not wait
   */
  public boolean is(GuidPrefix participant) {
    return self.filter(participant::equals).isPresent();
  }
}
